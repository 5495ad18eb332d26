#include <graze/engine/compare/judge/rational/rational_triangle.h>

#include <cmath>
#include <limits>
#include <vector>

namespace graze::compare {

RationalPoint exactly(const Eigen::Vector3d& p) {
  return {mpq_class(p.x()), mpq_class(p.y()), mpq_class(p.z())};
}

bool is_zero(const RationalPoint& p) {
  return p[0] == 0 && p[1] == 0 && p[2] == 0;
}

RationalPoint minus(const RationalPoint& p, const RationalPoint& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

mpq_class dot(const RationalPoint& p, const RationalPoint& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

RationalPoint cross(const RationalPoint& p, const RationalPoint& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

RationalPoint edge_of(const RationalTriangle& t, std::size_t i) {
  return minus(t[(i + 1) % 3], t[i]);
}

Extent extent_of(const RationalTriangle& triangle, const RationalPoint& axis) {
  Extent result{dot(triangle[0], axis), dot(triangle[0], axis)};
  for (std::size_t i = 1; i < 3; ++i) {
    const mpq_class value = dot(triangle[i], axis);
    if (value < result.min) result.min = value;
    if (value > result.max) result.max = value;
  }
  return result;
}

namespace {

RationalPoint placed(const Pose& pose, const Eigen::Vector3d& point) {
  const RationalPoint p = exactly(point);
  RationalPoint result;
  for (int i = 0; i < 3; ++i) {
    result[i] = mpq_class(pose(i, 3));
    for (int j = 0; j < 3; ++j)
      result[i] += mpq_class(pose(i, j)) * p[j];
  }
  return result;
}

using WholePoint = std::array<mpz_class, 3>;
using WholeTriangle = std::array<WholePoint, 3>;

/// Holds both triangles as integers, in units of one over the least common denominator.
struct WholePair {
  WholeTriangle a;
  WholeTriangle b;
  mpz_class denominator = 1;
};

WholePair whole(const RationalTriangle& a, const RationalTriangle& b) {
  WholePair result;
  for (const RationalTriangle* t : {&a, &b}) {
    for (const RationalPoint& point : *t) {
      for (const mpq_class& x : point)
        result.denominator = lcm(result.denominator, x.get_den());
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      result.a[i][k] = result.denominator / a[i][k].get_den() * a[i][k].get_num();
      result.b[i][k] = result.denominator / b[i][k].get_den() * b[i][k].get_num();
    }
  }
  return result;
}

mpz_class dot(const WholePoint& p, const WholePoint& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

using Matrix = std::array<std::array<mpz_class, 3>, 3>;

mpz_class determinant(const Matrix& m, std::size_t size) {
  if (size == 0) return 1;
  if (size == 1) return m[0][0];
  if (size == 2) return m[0][0] * m[1][1] - m[0][1] * m[1][0];
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Holds the corners of two triangles that two bit masks name: the first of each, and the edges to
/// the others, those of the second triangle backwards.
struct Supports {
  WholePoint apart;
  std::array<WholePoint, 3> edges;
  std::size_t edges_a = 0;
  std::size_t count = 0;

  /// Sets the masks. False if there are more than three edges, so that the system is singular in
  /// any case.
  bool set(const WholePair& pair, unsigned mask_a, unsigned mask_b) {
    count = 0;
    const std::size_t first_a = add(pair.a, mask_a, 1);
    edges_a = count;
    if (count > 3) return false;
    const std::size_t first_b = add(pair.b, mask_b, -1);
    for (std::size_t k = 0; k < 3; ++k)
      apart[k] = pair.a[first_a][k] - pair.b[first_b][k];
    return count <= 3;
  }

 private:
  std::size_t add(const WholeTriangle& t, unsigned mask, int sign) {
    std::size_t first = 3;
    for (std::size_t i = 0; i < 3; ++i) {
      if ((mask >> i & 1U) == 0) continue;
      if (first == 3) {
        first = i;
        continue;
      }
      if (count < 3) {
        for (std::size_t k = 0; k < 3; ++k)
          edges[count][k] = (t[i][k] - t[first][k]) * sign;
      }
      ++count;
    }
    return first;
  }
};

/// True if numbers over a common positive denominator, and what they leave of 1, are not negative.
bool are_weights(const std::array<mpz_class, 3>& weights, std::size_t first, std::size_t last,
                 const mpz_class& denominator) {
  mpz_class rest = denominator;
  for (std::size_t i = first; i < last; ++i) {
    if (sgn(weights[i]) < 0) return false;
    rest -= weights[i];
  }
  return sgn(rest) >= 0;
}

/// Finds the squared distance of the stationary points of two supports, if these lie in the hulls:
/// the normal equations are solved by Cramer's rule, whose determinant (of a Gram matrix) is never
/// negative.
bool find_stationary(const Supports& s, mpq_class& square) {
  Matrix gram;
  std::array<mpz_class, 3> right;
  for (std::size_t i = 0; i < s.count; ++i) {
    for (std::size_t j = 0; j < s.count; ++j)
      gram[i][j] = dot(s.edges[i], s.edges[j]);
    right[i] = -dot(s.edges[i], s.apart);
  }
  const mpz_class denominator = determinant(gram, s.count);
  if (sgn(denominator) == 0) return false;
  std::array<mpz_class, 3> weights;
  for (std::size_t j = 0; j < s.count; ++j) {
    Matrix replaced = gram;
    for (std::size_t i = 0; i < s.count; ++i)
      replaced[i][j] = right[i];
    weights[j] = determinant(replaced, s.count);
  }
  if (!are_weights(weights, 0, s.edges_a, denominator) ||
      !are_weights(weights, s.edges_a, s.count, denominator)) {
    return false;
  }
  WholePoint apart;
  for (std::size_t k = 0; k < 3; ++k) {
    apart[k] = s.apart[k] * denominator;
    for (std::size_t i = 0; i < s.count; ++i)
      apart[k] += weights[i] * s.edges[i][k];
  }
  square = mpq_class(dot(apart, apart), denominator * denominator);
  square.canonicalize();
  return true;
}

mpf_class precise_root(const mpq_class& square) {
  constexpr mp_bitcnt_t kBits = 2400;  // the range of squares of doubles, and their digits
  return sqrt(mpf_class(square, kBits));
}

}  // namespace

RationalTriangle exactly(const Triangle& t) {
  return {exactly(t.a), exactly(t.b), exactly(t.c)};
}

RationalTriangle placed_without_rounding(const Pose& pose, const Triangle& t) {
  return {placed(pose, t.a), placed(pose, t.b), placed(pose, t.c)};
}

mpq_class squared_distance(const RationalTriangle& triangle_a, const RationalTriangle& triangle_b) {
  const WholePair pair = whole(triangle_a, triangle_b);
  const mpq_class unknown = -1;
  mpq_class best = unknown;
  mpq_class square;
  Supports supports;
  for (unsigned mask_a = 1; mask_a < 8 && best != 0; ++mask_a) {
    for (unsigned mask_b = 1; mask_b < 8 && best != 0; ++mask_b) {
      if (!supports.set(pair, mask_a, mask_b) || !find_stationary(supports, square)) continue;
      if (best == unknown || square < best) best = square;
    }
  }
  return best / (pair.denominator * pair.denominator);
}

mpq_class squared_depth(const RationalTriangle& a, const RationalTriangle& b) {
  std::vector<RationalPoint> axes = {cross(edge_of(a, 0), edge_of(a, 1)),
                                     cross(edge_of(b, 0), edge_of(b, 1))};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      axes.push_back(cross(edge_of(a, i), edge_of(b, j)));
  }
  const mpq_class unknown = -1;
  mpq_class best = unknown;
  for (const RationalPoint& axis : axes) {
    const mpq_class length = dot(axis, axis);
    if (length == 0) continue;
    const Extent in_a = extent_of(a, axis);
    const Extent in_b = extent_of(b, axis);
    for (const mpq_class& overlap :
         {mpq_class(in_a.max - in_b.min), mpq_class(in_b.max - in_a.min)}) {
      if (overlap < 0) return 0;  // they are apart
      const mpq_class square = overlap * overlap / length;
      if (best == unknown || square < best) best = square;
    }
  }
  return best == unknown ? mpq_class(0) : best;  // if all are on one line a sideways move parts
                                                 // them
}

bool has_no_area(const RationalTriangle& triangle) {
  const RationalPoint normal = cross(edge_of(triangle, 0), edge_of(triangle, 1));
  return normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
}

double rounded_root(const mpq_class& square) {
  const mpf_class root = precise_root(square);
  return root > std::numeric_limits<double>::max() ? std::numeric_limits<double>::infinity()
                                                   : root.get_d();
}

double root_error(double value, const mpq_class& square) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // A number beyond the largest double rounds to infinity, without an error.
  if (value == kInfinity && rounded_root(square) == kInfinity) return 0;
  if (!std::isfinite(value)) return kInfinity;
  return root_error(mpq_class(value), square);
}

double root_error(const mpq_class& value, const mpq_class& square) {
  const mpf_class root = precise_root(square);
  const mpf_class error = abs(mpf_class(value, root.get_prec()) - root);
  return error > std::numeric_limits<double>::max() ? std::numeric_limits<double>::infinity()
                                                    : error.get_d();
}

}  // namespace graze::compare

#include <graze/engine/compare/judge/rational_triangle.h>

#include <cmath>
#include <limits>
#include <vector>

namespace graze::compare {
namespace {

RationalPoint exactly(const Eigen::Vector3d& p) {
  return {mpq_class(p.x()), mpq_class(p.y()), mpq_class(p.z())};
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

/// Solves the symmetric system in place by Gauss and Jordan; false if it is singular.
bool solve(std::vector<std::vector<mpq_class>>& rows) {
  const std::size_t count = rows.size();
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t pivot = k;
    while (pivot < count && rows[pivot][k] == 0)
      ++pivot;
    if (pivot == count) return false;
    swap(rows[k], rows[pivot]);
    for (std::size_t j = count + 1; j-- > k;)
      rows[k][j] /= rows[k][k];
    for (std::size_t i = 0; i < count; ++i) {
      if (i == k || rows[i][k] == 0) continue;
      const mpq_class factor = rows[i][k];
      for (std::size_t j = k; j <= count; ++j)
        rows[i][j] -= factor * rows[k][j];
    }
  }
  return true;
}

/// The corners of a triangle that a bit mask names, the first of them and the ways to the others.
struct Support {
  RationalPoint base;
  std::vector<RationalPoint> ways;

  Support(const RationalTriangle& triangle, unsigned mask) {
    bool is_first = true;
    for (std::size_t i = 0; i < 3; ++i) {
      if ((mask >> i & 1U) == 0) continue;
      if (is_first) {
        base = triangle[i];
      } else {
        ways.push_back(minus(triangle[i], base));
      }
      is_first = false;
    }
  }
};

/// Whether weights from `first` to `last`, and what they leave of 1, are not negative.
bool are_weights(const std::vector<mpq_class>& weights, std::size_t first, std::size_t last) {
  mpq_class rest = 1;
  for (std::size_t i = first; i < last; ++i) {
    if (weights[i] < 0) return false;
    rest -= weights[i];
  }
  return rest >= 0;
}

/// The squared distance of the stationary points of two supports, if these lie in the hulls.
bool find_stationary(const Support& a, const Support& b, mpq_class& square) {
  std::vector<RationalPoint> ways = a.ways;
  for (const RationalPoint& way : b.ways)
    ways.push_back({-way[0], -way[1], -way[2]});
  RationalPoint apart = minus(a.base, b.base);
  std::vector<std::vector<mpq_class>> rows(ways.size());
  for (std::size_t i = 0; i < ways.size(); ++i) {
    for (const RationalPoint& way : ways)
      rows[i].push_back(dot(ways[i], way));
    rows[i].push_back(-dot(ways[i], apart));
  }
  if (!solve(rows)) return false;
  std::vector<mpq_class> weights;
  for (const auto& row : rows)
    weights.push_back(row.back());
  if (!are_weights(weights, 0, a.ways.size()) ||
      !are_weights(weights, a.ways.size(), weights.size())) {
    return false;
  }
  for (std::size_t i = 0; i < ways.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      apart[k] += weights[i] * ways[i][k];
  }
  square = dot(apart, apart);
  return true;
}

struct Interval {
  mpq_class min;
  mpq_class max;
};

Interval extent(const RationalTriangle& triangle, const RationalPoint& axis) {
  Interval result{dot(triangle[0], axis), dot(triangle[0], axis)};
  for (std::size_t i = 1; i < 3; ++i) {
    const mpq_class value = dot(triangle[i], axis);
    if (value < result.min) result.min = value;
    if (value > result.max) result.max = value;
  }
  return result;
}

RationalPoint edge(const RationalTriangle& t, std::size_t i) {
  return minus(t[(i + 1) % 3], t[i]);
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
  const mpq_class unknown = -1;
  mpq_class best = unknown;
  mpq_class square;
  for (unsigned mask_a = 1; mask_a < 8; ++mask_a) {
    const Support a(triangle_a, mask_a);
    for (unsigned mask_b = 1; mask_b < 8; ++mask_b) {
      const Support b(triangle_b, mask_b);
      if (a.ways.size() + b.ways.size() > 3) continue;  // singular: there are three dimensions
      if (find_stationary(a, b, square) && (best == unknown || square < best)) best = square;
      if (best == 0) return best;
    }
  }
  return best;
}

mpq_class squared_depth(const RationalTriangle& a, const RationalTriangle& b) {
  std::vector<RationalPoint> axes = {cross(edge(a, 0), edge(a, 1)), cross(edge(b, 0), edge(b, 1))};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      axes.push_back(cross(edge(a, i), edge(b, j)));
  }
  const mpq_class unknown = -1;
  mpq_class best = unknown;
  for (const RationalPoint& axis : axes) {
    const mpq_class length = dot(axis, axis);
    if (length == 0) continue;
    const Interval in_a = extent(a, axis);
    const Interval in_b = extent(b, axis);
    for (const mpq_class& way : {mpq_class(in_a.max - in_b.min), mpq_class(in_b.max - in_a.min)}) {
      if (way < 0) return 0;  // they are apart
      const mpq_class square = way * way / length;
      if (best == unknown || square < best) best = square;
    }
  }
  return best == unknown ? mpq_class(0) : best;  // all on one line: a sideways move parts them
}

bool has_no_area(const RationalTriangle& triangle) {
  const RationalPoint normal = cross(edge(triangle, 0), edge(triangle, 1));
  return normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
}

double rounded_root(const mpq_class& square) {
  const mpf_class root = precise_root(square);
  return root > std::numeric_limits<double>::max() ? std::numeric_limits<double>::infinity()
                                                   : root.get_d();
}

double root_error(double value, const mpq_class& square) {
  if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
  const mpf_class root = precise_root(square);
  const mpf_class error = abs(mpf_class(value, root.get_prec()) - root);
  return error > std::numeric_limits<double>::max() ? std::numeric_limits<double>::infinity()
                                                    : error.get_d();
}

}  // namespace graze::compare

#include "tests/narrowphase/motion/rational_nearness.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tests/narrowphase/motion/rational_polynomial.h"

namespace graze::oracle {
namespace {

// Those for points and paths below do not hide them.
using oracle::operator+;
using oracle::operator-;
using oracle::operator*;

using Point = std::array<mpq_class, 3>;

Point operator-(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

mpq_class dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point along(const Point& from, const Point& way, const mpq_class& by) {
  return {from[0] + by * way[0], from[1] + by * way[1], from[2] + by * way[2]};
}

/// Squares of distances at one time, by going to the nearest point.
mpq_class square_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point way = b - a;
  const mpq_class square = dot(way, way);
  mpq_class by = square == 0 ? mpq_class(0) : mpq_class(dot(p - a, way) / square);
  by = std::min(std::max(by, mpq_class(0)), mpq_class(1));
  const Point offset = p - along(a, way, by);
  return dot(offset, offset);
}

/// Solves for the point of the plane, or of both lines, that is nearest: two equations by Cramer's
/// rule; nothing where they are one.
struct TwoWays {
  mpq_class on_u, on_v;
};
std::optional<TwoWays> nearest_by_two(const Point& offset, const Point& u, const Point& v) {
  const mpq_class uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
  const mpq_class determinant = uu * vv - uv * uv;
  if (determinant == 0) return std::nullopt;
  const mpq_class by_u = dot(offset, u), by_v = dot(offset, v);
  return TwoWays{(by_u * vv - by_v * uv) / determinant, (uu * by_v - uv * by_u) / determinant};
}

mpq_class square_to_triangle(const std::array<Point, 4>& p) {
  mpq_class least = square_to_segment(p[0], p[3], p[1]);
  for (int i = 1; i < 3; ++i)
    least = std::min(least, square_to_segment(p[0], p[i], p[i + 1]));
  const Point u = p[2] - p[1], v = p[3] - p[1];
  const auto found = nearest_by_two(p[0] - p[1], u, v);
  if (!found || found->on_u < 0 || found->on_v < 0 || found->on_u + found->on_v > 1) return least;
  const Point offset = p[0] - along(along(p[1], u, found->on_u), v, found->on_v);
  return std::min(least, dot(offset, offset));
}

mpq_class square_of_segments(const std::array<Point, 4>& p) {
  mpq_class least = square_to_segment(p[0], p[2], p[3]);
  least = std::min(least, square_to_segment(p[1], p[2], p[3]));
  least = std::min(least, square_to_segment(p[2], p[0], p[1]));
  least = std::min(least, square_to_segment(p[3], p[0], p[1]));
  // p0 + x u = p2 + y v, as nearly as can be.
  const Point u = p[1] - p[0], v = p[2] - p[3];
  const auto found = nearest_by_two(p[2] - p[0], u, v);
  if (!found || found->on_u < 0 || found->on_u > 1 || found->on_v < 0 || found->on_v > 1)
    return least;
  const Point offset = (p[2] - p[0]) - along(along({0, 0, 0}, u, found->on_u), v, found->on_v);
  return std::min(least, dot(offset, offset));
}

// Polynomials, as the library has them: there is but one formula for these.
using Path = std::array<RationalPolynomial, 3>;

Path operator-(const Path& a, const Path& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
RationalPolynomial dot(const Path& a, const Path& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Path cross(const Path& a, const Path& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Near where the size is positive, the gap is not, and no side is negative.
struct Feature {
  RationalPolynomial gap, size;
  std::vector<RationalPolynomial> sides;
};

struct Question {
  std::array<PointPath, 4> paths;
  bool is_edges;
  mpq_class square;
  std::vector<Feature> features;

  Question(const std::array<PointPath, 4>& four, bool are_edges, double clearance)
      : paths(four), is_edges(are_edges), square(mpq_class(clearance) * mpq_class(clearance)) {
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 3; ++k) {
        const mpq_class start(paths[i].start[k]), end(paths[i].end[k]);
        path_[i][k] = RationalPolynomial{start, 0} + RationalPolynomial{0, end - start};
      }
    }
    if (is_edges) {
      add_edges();
      for (int i = 0; i < 2; ++i) {
        add_edge(i, 2, 3), add_edge(2 + i, 0, 1), add_corner(i, 2), add_corner(i, 3);
      }
    } else {
      add_face();
      for (int i = 1; i <= 3; ++i) {
        add_edge(0, i, i % 3 + 1), add_corner(0, i);
      }
    }
    for (Feature& feature : features) {
      feature.gap = in_integers(feature.gap);
      feature.size = in_integers(feature.size);
      for (RationalPolynomial& side : feature.sides)
        side = in_integers(side);
    }
  }

  bool is_near_at(const mpq_class& t) const {
    std::array<Point, 4> p;
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 3; ++k)
        p[i][k] = mpq_class(paths[i].start[k]) * (1 - t) + mpq_class(paths[i].end[k]) * t;
    }
    return (is_edges ? square_of_segments(p) : square_to_triangle(p)) <= square;
  }

  bool is_near_at(const RationalRoot& root) const {
    return std::any_of(features.begin(), features.end(), [&](const Feature& f) {
      return sign_at(f.size, root) > 0 && sign_at(f.gap, root) <= 0 &&
             std::all_of(f.sides.begin(), f.sides.end(),
                         [&](const auto& side) { return sign_at(side, root) >= 0; });
    });
  }

 private:
  RationalPolynomial times_square(const RationalPolynomial& f) const {
    return f * RationalPolynomial{square, 0};
  }
  void add_corner(int p, int q) {
    const Path w = path_[p] - path_[q];
    const RationalPolynomial one{mpq_class(1)};
    features.push_back({dot(w, w) - times_square(one), one, {}});
  }
  void add_edge(int p, int from, int to) {
    const Path edge = path_[to] - path_[from], w = path_[p] - path_[from];
    const RationalPolynomial size = dot(edge, edge), foot = dot(w, edge);
    // The square of w less that of its part along the edge.
    features.push_back(
        {dot(w, w) * size - foot * foot - times_square(size), size, {foot, size - foot}});
  }
  void add_face() {
    const Path u = path_[2] - path_[1], v = path_[3] - path_[1], w = path_[0] - path_[1];
    const Path normal = cross(u, v);
    const RationalPolynomial size = dot(normal, normal), height = dot(w, normal);
    const RationalPolynomial on_u = dot(cross(w, v), normal), on_v = dot(cross(u, w), normal);
    features.push_back(
        {height * height - times_square(size), size, {on_u, on_v, size - on_u - on_v}});
  }
  void add_edges() {
    const Path e = path_[1] - path_[0], f = path_[3] - path_[2], w = path_[2] - path_[0];
    const Path normal = cross(e, f);
    const RationalPolynomial size = dot(normal, normal), height = dot(w, normal);
    const RationalPolynomial x = dot(cross(w, f), normal), y = dot(cross(w, e), normal);
    features.push_back({height * height - times_square(size), size, {x, size - x, y, size - y}});
  }

  std::array<Path, 4> path_;
};

std::optional<FirstContact> answer(const Question& question, StartContact start) {
  std::vector<RationalPolynomial> polynomials;
  const auto take = [&](const RationalPolynomial& f) {
    if (!f.empty()) polynomials.push_back(square_free(f));
  };
  for (const Feature& feature : question.features) {
    take(feature.gap), take(feature.size);
    for (const RationalPolynomial& side : feature.sides)
      take(side);
  }
  std::vector<RationalRoot> roots = all_roots(polynomials);
  bool is_leaving = question.is_near_at(mpq_class(0));
  if (is_leaving && start == StartContact::Counts) return FirstContact{0, true};
  mpq_class reached = 0;
  bool was_near = is_leaving;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    RationalRoot& root = roots[i];
    if (i > 0) {
      compare(roots[i - 1], root);  // so that their stretches are apart
      reached = roots[i - 1].high;
    }
    if (root.low > 0) {
      was_near = question.is_near_at((reached + root.low) / 2);
      is_leaving = is_leaving && was_near;
    }
    const bool is_near = question.is_near_at(root);
    if (was_near && !is_near) {
      std::fprintf(stderr, "what is near up to a time is not near then\n");
      std::abort();
    }
    if (is_near && !is_leaving) return FirstContact{rounded_down(root), false};
    is_leaving = is_leaving && is_near;
  }
  return std::nullopt;
}

}  // namespace

std::optional<FirstContact> rational_nearness(const PointPath& point, const TrianglePath& triangle,
                                              const FirstContactSettings& settings) {
  return answer({{point, triangle.a, triangle.b, triangle.c}, false, settings.clearance},
                settings.start);
}

std::optional<FirstContact> rational_nearness(const EdgePath& a, const EdgePath& b,
                                              const FirstContactSettings& settings) {
  return answer({{a.a, a.b, b.a, b.b}, true, settings.clearance}, settings.start);
}

}  // namespace graze::oracle

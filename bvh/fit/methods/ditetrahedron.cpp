#include <graze/bvh/fit/methods/ditetrahedron.h>
#include <graze/bvh/fit/methods/extremal_pairs.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace graze::bvh {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr std::array<Direction, 7> kDirections{
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}}};

/// The least and greatest heights of points along a direction, and the points that have them.
struct Span {
  double low;
  double high;
  std::size_t lowest;
  std::size_t highest;
};

Span span_along(const Points& points, const Eigen::Vector3d& direction) {
  Span span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0,
            0};
  const double* d = direction.data();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double* p = points[i].data();
    const double h = p[0] * d[0] + p[1] * d[1] + p[2] * d[2];
    if (h < span.low) {
      span.low = h;
      span.lowest = i;
    }
    if (h > span.high) {
      span.high = h;
      span.highest = i;
    }
  }
  return span;
}

double length_along(const Points& points, const Eigen::Vector3d& direction) {
  const Span span = span_along(points, direction);
  return span.high - span.low;
}

/// The best axes so far for boxes around a few points.
class Chooser {
 public:
  explicit Chooser(const Points& points) : points_(points) {}

  /// Tries the three boxes with one axis along the triangle's normal and one along an edge.
  void try_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const std::array<Eigen::Vector3d, 3> edges{b - a, c - b, a - c};
    Eigen::Vector3d normal = edges[0].cross(edges[1]);
    const double length = normal.norm();
    if (!(length > 0)) return;
    normal /= length;
    const double height = length_along(points_, normal);
    for (const Eigen::Vector3d& edge : edges) {
      const Eigen::Vector3d along = edge.normalized();
      const double width = length_along(points_, along);
      const double depth = length_along(points_, normal.cross(along));
      const double surface = width * height + height * depth + depth * width;
      if (surface < best_surface_) {
        best_surface_ = surface;
        first_ = edge;
        second_ = normal;
      }
    }
  }

  /// Tries the box along the line through two points, if nothing else is known: so it is for
  /// collinear points.
  void try_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    if (best_surface_ == std::numeric_limits<double>::infinity()) first_ = b - a;
  }

  Axes axes() const { return axes_along(first_, second_); }

 private:
  const Points& points_;
  double best_surface_ = std::numeric_limits<double>::infinity();
  Eigen::Vector3d first_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d second_ = Eigen::Vector3d::Zero();
};

/// Returns the point farthest from the line through a and b.
const Eigen::Vector3d& far_from_line(const Points& points, const Eigen::Vector3d& a,
                                     const Eigen::Vector3d& b) {
  const Eigen::Vector3d direction = (b - a).normalized();
  const Eigen::Vector3d* best = &points.front();
  double best_square = -1;
  for (const Eigen::Vector3d& point : points) {
    const double square = (point - a).cross(direction).squaredNorm();
    if (square > best_square) {
      best_square = square;
      best = &point;
    }
  }
  return *best;
}

}  // namespace

Axes ditetrahedron_axes(const LocalPoints& points) {
  const std::vector<ExtremalPair> pairs = extremal_pairs(points, kDirections);
  const ExtremalPair* widest = &pairs.front();
  double best_square = -1;
  std::vector<std::size_t> indices;
  for (const ExtremalPair& pair : pairs) {
    const double square = (points.point(pair.high) - points.point(pair.low)).squaredNorm();
    if (square > best_square) {
      best_square = square;
      widest = &pair;
    }
    indices.insert(indices.end(), {pair.low, pair.high});
  }
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  Points few;
  for (std::size_t i : indices)
    few.push_back(points.point(i));

  const Eigen::Vector3d a = points.point(widest->low);
  const Eigen::Vector3d b = points.point(widest->high);
  const Eigen::Vector3d c = far_from_line(few, a, b);
  Chooser chooser(few);
  chooser.try_triangle(a, b, c);
  const Span span = span_along(few, (b - a).cross(c - a));
  for (std::size_t tip : {span.lowest, span.highest}) {
    chooser.try_triangle(a, b, few[tip]);
    chooser.try_triangle(b, c, few[tip]);
    chooser.try_triangle(c, a, few[tip]);
  }
  chooser.try_line(a, b);
  return chooser.axes();
}

}  // namespace graze::bvh

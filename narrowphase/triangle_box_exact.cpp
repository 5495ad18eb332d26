#include <graze/narrowphase/coplanar.h>
#include <graze/narrowphase/finite.h>
#include <graze/narrowphase/predicates.h>
#include <graze/narrowphase/triangle_box.h>
#include <algorithm>

namespace graze::narrowphase {
namespace {

struct Range {
  double min;
  double max;
};

bool is_apart_along_box_axis(const Corners<double>& triangle, const Aabb& box, int i) {
  const double a = triangle.point[0][i];
  const double b = triangle.point[1][i];
  const double c = triangle.point[2][i];
  return std::min({a, b, c}) > box.max.data()[i] || std::max({a, b, c}) < box.min.data()[i];
}

/// The corner of the rectangle farthest to the left of the direction from `a` to `b`. Comparing
/// coordinates gives the exact signs of their difference.
Point2 leftmost_corner(Point2 a, Point2 b, Range x, Range y) {
  return {b.y > a.y ? x.min : x.max, b.x > a.x ? y.max : y.min};
}

/// In the projection along a box axis, an edge line of the triangle separates it from the box's
/// rectangle. These are the nine axes e_i x f_j of the paper, but only their halves beyond the
/// edge: in a plane two convex polygons that are apart have an edge line of one with the other
/// beyond it, so that the halves beyond the opposite vertex are never needed.
bool is_apart_along_edges(const Point2 (&corner)[3], Sign turn, Range x, Range y) {
  for (int i = 0; i < 3; ++i) {
    const Point2 a = corner[i];
    const Point2 b = corner[(i + 1) % 3];
    const bool all_right = turn != Sign::Negative &&
                           orientation_2d(a, b, leftmost_corner(a, b, x, y)) == Sign::Negative;
    const bool all_left = turn != Sign::Positive &&
                          orientation_2d(b, a, leftmost_corner(b, a, x, y)) == Sign::Negative;
    if (all_right || all_left) return true;
  }
  return false;
}

/// The plane of the triangle separates it from the box: the two vertices of the box diagonal
/// nearest to the normal are on one side. Without a normal all signs are zero, and so is the
/// answer.
bool is_apart_along_normal(const Corners<double>& triangle, const Sign (&normal)[3],
                           const Aabb& box) {
  double low[3];
  double high[3];
  for (int i = 0; i < 3; ++i) {
    const bool is_negative = normal[i] == Sign::Negative;
    low[i] = is_negative ? box.max.data()[i] : box.min.data()[i];
    high[i] = is_negative ? box.min.data()[i] : box.max.data()[i];
  }
  const double* const* p = triangle.point;
  return orientation_3d(p[0], p[1], p[2], low) == Sign::Positive ||
         orientation_3d(p[0], p[1], p[2], high) == Sign::Negative;
}

}  // namespace

bool intersects_exactly(const Triangle& triangle, const Aabb& box) {
  check_finite(triangle, "triangle");
  check_box(box, "box");
  const Corners<double> corners{{triangle.a.data(), triangle.b.data(), triangle.c.data()}};
  for (int i = 0; i < 3; ++i) {
    if (is_apart_along_box_axis(corners, box, i)) return false;
  }
  Sign normal[3];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const Point2 projected[3] = {project(corners.point[0], i), project(corners.point[1], i),
                                 project(corners.point[2], i)};
    normal[i] = orientation_2d(projected[0], projected[1], projected[2]);
    const Range x{box.min.data()[j], box.max.data()[j]};
    const Range y{box.min.data()[k], box.max.data()[k]};
    if (is_apart_along_edges(projected, normal[i], x, y)) return false;
  }
  return !is_apart_along_normal(corners, normal, box);
}

}  // namespace graze::narrowphase

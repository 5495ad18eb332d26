#include <graze/bvh/value/checks.h>
#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/predicates/fixed_point.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <algorithm>

namespace graze::narrowphase {
namespace {

/// Holds a box by its two extreme corners, in the same numbers as the triangle's.
template <typename Number>
struct BoxCorners {
  const Number* min;
  const Number* max;
};

template <typename Number>
bool is_apart_along_box_axis(const Corners<Number>& triangle, const BoxCorners<Number>& box,
                             int i) {
  const Number a = triangle.point[0][i];
  const Number b = triangle.point[1][i];
  const Number c = triangle.point[2][i];
  return std::min({a, b, c}) > box.max[i] || std::max({a, b, c}) < box.min[i];
}

/// Returns the corner of the rectangle farthest to the left of the direction from `a` to `b`.
/// Comparing coordinates gives the exact signs of their difference.
template <typename Point>
Point leftmost_corner(Point a, Point b, Point min, Point max) {
  return {b.y > a.y ? min.x : max.x, b.x > a.x ? max.y : min.y};
}

/// True if, in the projection along a box axis, an edge line of the triangle separates it from the
/// box's rectangle. These are the nine axes e_i x f_j of the paper, but only their halves beyond
/// the edge: in a plane two convex polygons that are apart have an edge line of one with the other
/// beyond it, so that the halves beyond the opposite vertex are never needed.
template <typename Point>
bool is_apart_along_edges(const Point (&corner)[3], Sign turn, Point min, Point max) {
  for (int i = 0; i < 3; ++i) {
    const Point a = corner[i];
    const Point b = corner[(i + 1) % 3];
    const bool all_right = turn != Sign::Negative &&
                           orientation_2d(a, b, leftmost_corner(a, b, min, max)) == Sign::Negative;
    const bool all_left = turn != Sign::Positive &&
                          orientation_2d(b, a, leftmost_corner(b, a, min, max)) == Sign::Negative;
    if (all_right || all_left) return true;
  }
  return false;
}

/// True if the plane of the triangle separates it from the box: the two vertices of the box
/// diagonal nearest to the normal are on one side. Without a normal all signs are zero, and so is
/// the answer.
template <typename Number>
bool is_apart_along_normal(const Corners<Number>& triangle, const Sign (&normal)[3],
                           const BoxCorners<Number>& box) {
  Number low[3];
  Number high[3];
  for (int i = 0; i < 3; ++i) {
    const bool is_negative = normal[i] == Sign::Negative;
    low[i] = is_negative ? box.max[i] : box.min[i];
    high[i] = is_negative ? box.min[i] : box.max[i];
  }
  const Number* const* p = triangle.point;
  return orientation_3d(p[0], p[1], p[2], low) == Sign::Positive ||
         orientation_3d(p[0], p[1], p[2], high) == Sign::Negative;
}

template <typename Number>
bool meet_exactly(const Corners<Number>& triangle, const BoxCorners<Number>& box) {
  for (int i = 0; i < 3; ++i) {
    if (is_apart_along_box_axis(triangle, box, i)) return false;
  }
  using Point = decltype(project(box.min, 0));
  Sign normal[3];
  for (int i = 0; i < 3; ++i) {
    const Point projected[3] = {project(triangle.point[0], i), project(triangle.point[1], i),
                                project(triangle.point[2], i)};
    normal[i] = orientation_2d(projected[0], projected[1], projected[2]);
    if (is_apart_along_edges(projected, normal[i], project(box.min, i), project(box.max, i))) {
      return false;
    }
  }
  return !is_apart_along_normal(triangle, normal, box);
}

}  // namespace

bool intersects_exactly(const Triangle& triangle, const Aabb& box) {
  check_finite(triangle, "triangle");
  bvh::check_box(box, "box");
  const double* corners = coordinates(triangle);
  const double* const points[5] = {corners, corners + 3, corners + 6, box.min.data(),
                                   box.max.data()};
  FixedPoint fixed[5];
  if (to_fixed_point(points, 5, fixed)) {
    return meet_exactly(Corners<std::int64_t>{{fixed[0], fixed[1], fixed[2]}},
                        BoxCorners<std::int64_t>{fixed[3], fixed[4]});
  }
  return meet_exactly(Corners<double>{{points[0], points[1], points[2]}},
                      BoxCorners<double>{points[3], points[4]});
}

}  // namespace graze::narrowphase

#pragma once

// Tests triangles and segments in one plane, exactly, by comparisons and by orientations in
// projections along an axis. Coordinates are doubles, or integers (fixed_point.h).

#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/predicates/fixed_point.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <algorithm>

namespace graze::narrowphase {

template <typename Number>
bool ranges_overlap(Number a0, Number a1, Number b0, Number b1) {
  return std::min(a0, a1) <= std::max(b0, b1) && std::min(b0, b1) <= std::max(a0, a1);
}

inline bool are_on_one_side(Sign s, Sign t) {
  return s != Sign::Zero && s == t;
}

/// Two closed segments in the plane meet if and only if their boxes overlap and neither lies
/// strictly on one side of the other's line. A point's line holds every point, so that the other
/// segment's line and the boxes decide for it.
template <typename Point>
bool segments_intersect(Point a0, Point a1, Point b0, Point b1) {
  return ranges_overlap(a0.x, a1.x, b0.x, b1.x) && ranges_overlap(a0.y, a1.y, b0.y, b1.y) &&
         !are_on_one_side(orientation_2d(a0, a1, b0), orientation_2d(a0, a1, b1)) &&
         !are_on_one_side(orientation_2d(b0, b1, a0), orientation_2d(b0, b1, a1));
}

/// True if and only if the closed segments [a0, a1] and [b0, b1] in space share a point. Segments
/// that are points are what they are.
template <typename Number>
bool segments_intersect(const Number* a0, const Number* a1, const Number* b0, const Number* b1) {
  // The four points are in one plane. Along at least one axis the projection of that plane is one
  // to one, and there the projections meet if and only if the segments do. In the others they meet
  // if those do. If the four points are collinear the same holds of their line.
  if (orientation_3d(a0, a1, b0, b1) != Sign::Zero) return false;
  for (int axis = 0; axis < 3; ++axis) {
    if (!segments_intersect(project(a0, axis), project(a1, axis), project(b0, axis),
                            project(b1, axis))) {
      return false;
    }
  }
  return true;
}

/// True if a closed triangle contains a point. One without area contains nothing here: it is the
/// union of its edges, which are tested by themselves.
template <typename Point>
bool contains(const Point (&triangle)[3], Point point) {
  bool has_positive = false;
  bool has_negative = false;
  for (int i = 0; i < 3; ++i) {
    const Sign sign = orientation_2d(triangle[i], triangle[(i + 1) % 3], point);
    has_positive |= sign == Sign::Positive;
    has_negative |= sign == Sign::Negative;
  }
  return has_positive != has_negative;
}

/// True if some edge of a triangle, which has area and turns as `turn` says, has all of another
/// triangle strictly beyond it.
template <typename Point>
bool has_separating_edge(const Point (&triangle)[3], Sign turn, const Point (&other)[3]) {
  for (int i = 0; i < 3; ++i) {
    const Point from = triangle[i];
    const Point to = triangle[(i + 1) % 3];
    if (orientation_2d(from, to, other[0]) == -turn &&
        orientation_2d(from, to, other[1]) == -turn &&
        orientation_2d(from, to, other[2]) == -turn) {
      return true;
    }
  }
  return false;
}

/// True if and only if the projections of the two closed triangles along `axis` share a point.
/// Projections that degenerate to segments and points are what they are.
template <typename Number>
bool projections_intersect(const Corners<Number>& triangle_a, const Corners<Number>& triangle_b,
                           int axis) {
  using Point = decltype(project(triangle_a.point[0], axis));
  const Point a[3] = {project(triangle_a.point[0], axis), project(triangle_a.point[1], axis),
                      project(triangle_a.point[2], axis)};
  const Point b[3] = {project(triangle_b.point[0], axis), project(triangle_b.point[1], axis),
                      project(triangle_b.point[2], axis)};
  const Sign turn_a = orientation_2d(a[0], a[1], a[2]);
  const Sign turn_b = orientation_2d(b[0], b[1], b[2]);
  // Two convex polygons that are apart have an edge of one with the other beyond it.
  if (turn_a != Sign::Zero && turn_b != Sign::Zero) {
    return !has_separating_edge(a, turn_a, b) && !has_separating_edge(b, turn_b, a);
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (segments_intersect(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3])) return true;
    }
  }
  // No edges meet: either one triangle holds the other whole, or they are apart.
  return contains(b, a[0]) || contains(a, b[0]);
}

}  // namespace graze::narrowphase

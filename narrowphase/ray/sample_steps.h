#pragma once

// Finds how points that are moved by powers of an infinitesimal lie to edges and planes. Private to
// narrowphase/ray.

#include <graze/narrowphase/derived/sign_of_products.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/ray/axis_line.h>

namespace graze::narrowphase {

using SampleCorners = const double* const (&)[3];

inline Step unit_step(int axis) {
  static constexpr double kNoStep[3] = {0, 0, 0};
  static constexpr double kUnitSteps[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return {kNoStep, kUnitSteps[axis]};
}

/// Returns the sign of the product of two numbers with these signs.
inline Sign product(Sign s, Sign t) {
  return static_cast<Sign>(static_cast<int>(s) * static_cast<int>(t));
}

/// Returns to which side of a line along `axis` the last steps of a sample lead, which are along
/// the axes: zero only for an edge that is seen as a point.
inline Sign last_side_of_edge(Step edge, int axis) {
  Sign sign = Sign::Zero;
  for (int k = 0; k < 3 && sign == Sign::Zero; ++k)
    sign = sign_of_triple(edge, unit_step(k), unit_step(axis));
  return sign;
}

/// Returns which way a triangle turns as it is seen along an axis; zero if it is seen as a segment
/// or a point.
inline Sign turn_along(SampleCorners corner, int axis) {
  return orientation_2d(project(corner[0], axis), project(corner[1], axis),
                        project(corner[2], axis));
}

/// Returns to which side of the plane of a triangle with area the last steps lead: never zero.
inline Sign last_side_of_plane(SampleCorners corner) {
  Sign sign = Sign::Zero;
  for (int k = 0; k < 3 && sign == Sign::Zero; ++k)
    sign = turn_along(corner, k);
  return sign;
}

/// Finds how a triangle crosses the line along `axis` through a sample that lies on these sides of
/// its edges, seen along the axis, and of its plane, which is asked last.
template <typename SideOfEdge, typename SideOfPlane>
LineCrossing crossing_by_sides(SampleCorners corner, int axis, const SideOfEdge& side_of_edge,
                               const SideOfPlane& side_of_plane) {
  const Sign first = side_of_edge(corner[0], corner[1]);
  if (first == Sign::Zero || side_of_edge(corner[1], corner[2]) != first ||
      side_of_edge(corner[2], corner[0]) != first)
    return LineCrossing::None;
  // The line goes through the inside of what is seen, which has an area then: neither is zero.
  return side_of_plane() == turn_along(corner, axis) ? LineCrossing::Below : LineCrossing::Above;
}

}  // namespace graze::narrowphase

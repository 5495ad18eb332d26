#pragma once

// This file holds points in rational numbers, beside the plane that they lie in, so that crossings
// of surfaces can be counted from there. They are slow, and serve where no corner of a triangle can
// answer. Private to the library.

#include <graze/bvh/aabb.h>
#include <graze/narrowphase/predicates/growing_integer.h>
#include <graze/narrowphase/ray/axis_line.h>

#include <array>

namespace graze::narrowphase {

/// The point with coordinates at[k] / weight, counted in units of 2^unit.
struct RationalPoint {
  std::array<GrowingInteger, 3> at;
  GrowingInteger weight;  ///< above 0
  int unit = 0;
};

/// A box of doubles that holds the point, which lies between finite doubles, and is some units in
/// the last place wide.
Aabb box_around(const RationalPoint& point);

/// A point p beside a plane: for an e > 0 too small to matter otherwise, p + e n + e^2 (1, e, e^2),
/// with n the normal of a triangle in that plane, (b - a) x (c - a), or its opposite. It lies on no
/// triangle, and an axis line through it meets no edge.
struct RationalSample {
  const RationalPoint& point;
  const Aabb& around;        ///< the box that box_around() returns for the point
  const Triangle& triangle;  ///< has area; the point lies in its plane
  Sign side;                 ///< Positive: where n points
};

/// Answers as cross_axis_line() of a moved point does. Exact for finite input.
LineCrossing cross_axis_line(const Triangle& triangle, const RationalSample& sample, int axis);

}  // namespace graze::narrowphase

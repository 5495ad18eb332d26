#pragma once

// This file holds points that are as near to a triangle as can be, so that crossings of surfaces
// can be counted from there. Private to the library.

#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/ray/axis_line.h>

namespace graze::narrowphase {

/// A point beside the inside of a triangle with corners a, b, c: for an e > 0 too small to matter
/// otherwise, a + e (b - a) + e^2 (c - a) + e^3 n + e^4 (1, e, e^2), with n = (b - a) x (c - a) or
/// its opposite. It lies on no triangle, and an axis line through it meets no edge.
struct FaceSample {
  Triangle triangle;  ///< has area
  Sign side;          ///< Positive: where n = (b - a) x (c - a) points
};

/// Answers as cross_axis_line() of a moved point does. Exact for finite input.
LineCrossing cross_axis_line(const Triangle& triangle, const FaceSample& sample, int axis);

}  // namespace graze::narrowphase

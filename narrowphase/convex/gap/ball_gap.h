#pragma once

#include <graze/bvh/sphere.h>
#include <graze/narrowphase/convex/core/vector.h>
#include <graze/narrowphase/triangle.h>

namespace graze::narrowphase {

/// Holds how far a triangle is from the surface of a ball, metres: lower <= gap <= upper, both
/// proved; a triangle that reaches into the ball has a gap below 0. The two are some 2^-95 of the
/// largest length apart plus a part in 2^49 of the gap, unless a triangle is no wider than
/// rounding.
struct BallGap {
  double lower;
  double upper;   ///< the distance beyond the surface of a point of the triangle
  Vec3 to_point;  ///< that point, seen from the ball's centre
  Vec3 normal;    ///< unit, from the ball's centre to the plane that proves `lower`
};

/// Returns the gap of a ball and a triangle, which may have no area, computed in twice the
/// precision of double. The caller makes sure that both are finite and within kLargestLength.
BallGap ball_gap(const Sphere& ball, const Triangle& triangle);

}  // namespace graze::narrowphase

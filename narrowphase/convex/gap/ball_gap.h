#pragma once

#include <graze/bvh/sphere.h>
#include <graze/narrowphase/convex/core/vector.h>
#include <graze/narrowphase/triangle.h>

namespace graze::narrowphase {

/// How far a triangle is from the surface of a ball, metres: lower <= gap <= upper, both proved; a
/// triangle that reaches into the ball has a gap below 0. The two are some 2^-95 of the largest
/// length apart and a part in 2^49 of the gap, unless rounding is all that a triangle is wide.
struct BallGap {
  double lower;
  double upper;   ///< beyond the surface, of a point of the triangle
  Vec3 to_point;  ///< that point, seen from the ball's centre
  Vec3 normal;    ///< unit, from the ball's centre to the plane that proves `lower`
};

/// Of a ball and a triangle, which may have no area, in twice the precision of double. Finite, and
/// within kLargestLength: the caller's duty.
BallGap ball_gap(const Sphere& ball, const Triangle& triangle);

}  // namespace graze::narrowphase

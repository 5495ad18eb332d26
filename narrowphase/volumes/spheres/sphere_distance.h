#pragma once

// Compares the distance from a centre to a point with a radius, which all tests of spheres come
// down to. Points are arrays of three finite doubles, radii finite and not negative.

#include <graze/bvh/aabb.h>
#include <graze/bvh/sphere.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <array>
#include <optional>

namespace graze::narrowphase {

// The error bound by which rounded squares of distances are compared, for one pair at a time and
// for many at once. Notation as in predicates.cpp: u is the unit roundoff, n the smallest
// double.
//
// s = (x x + y y) + z z, with x, y, z differences of inputs, and q = r r, with r an input or a sum
// of two. Each difference carries one rounding, hence each square three, and the sums two more: s
// is off by at most (1 + u)^5 - 1 < 5.0001 u of the exact value, 5.001 u s of the computed one; q
// by at most 3.001 u q. Comparing s - q with 8 u (s + q) + 2^-1000 rounds four times more: 2.001 u
// (s + q), and u 2^-1000. Four products may underflow, and the bound's own: 2.5 n, far below
// 2^-1000.
//
// What overflows is unsure by itself: then the bound is infinite, or NaN, and nothing exceeds it.
inline constexpr double kSquareBound = 8 * 0x1p-53;
inline constexpr double kSquareUnderflow = 0x1p-1000;

/// Returns the point of the solid box nearest to `point`, exactly: each coordinate is one of the
/// inputs.
std::array<double, 3> nearest_point(const Aabb& box, const double* point);

/// Returns the sign of |offset|^2 - radius^2 where that is sure. Each component of the offset, and
/// the radius, may be off by one rounding.
inline std::optional<Sign> sign_of_offset(const double* offset, double radius) {
  const double distance2 = (offset[0] * offset[0] + offset[1] * offset[1]) + offset[2] * offset[2];
  const double radius2 = radius * radius;
  const double bound = kSquareBound * (distance2 + radius2) + kSquareUnderflow;
  const double gap = distance2 - radius2;
  if (gap > bound) return Sign::Positive;
  if (gap < -bound) return Sign::Negative;
  return std::nullopt;
}

/// Returns the sign of |to - from| - radius: the first function where rounded arithmetic is sure of
/// it, the second always, by integers.
inline std::optional<Sign> sign_of_distance(const double* from, const double* to, double radius) {
  const double offset[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  return sign_of_offset(offset, radius);
}
Sign sign_of_distance_exact(const double* from, const double* to, double radius);

/// Does the same for the radius radius_a + radius_b; the rounded stage rounds the sum within its
/// bound.
inline std::optional<Sign> sign_of_distance(const double* from, const double* to, double radius_a,
                                            double radius_b) {
  return sign_of_distance(from, to, radius_a + radius_b);
}
Sign sign_of_distance_exact(const double* from, const double* to, double radius_a, double radius_b);

/// Ask the exact stages of decide() alone, for valid volumes.
bool overlap_exactly(const Sphere& sphere_a, const Sphere& sphere_b);
bool overlap_exactly(const Sphere& sphere, const Aabb& box);

}  // namespace graze::narrowphase

#pragma once

// How far is it from a centre to a point, seen from a radius: what all tests of spheres are made
// of. Points are arrays of three finite doubles, radii finite and not negative.

#include <graze/bvh/aabb.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/volumes/spheres/sphere_bound.h>
#include <array>
#include <optional>

namespace graze::narrowphase {

/// The point of the solid box nearest to `point`, exactly: each coordinate is one of the inputs.
std::array<double, 3> nearest_point(const Aabb& box, const double* point);

/// The sign of |way|^2 - radius^2 where that is sure, from the components of the way, each off by
/// one rounding at most, and the radius, likewise.
inline std::optional<Sign> sign_of_reach(const double* way, double radius) {
  const double distance2 = (way[0] * way[0] + way[1] * way[1]) + way[2] * way[2];
  const double radius2 = radius * radius;
  const double bound = kSquareBound * (distance2 + radius2) + kSquareUnderflow;
  const double gap = distance2 - radius2;
  if (gap > bound) return Sign::Positive;
  if (gap < -bound) return Sign::Negative;
  return std::nullopt;
}

/// The sign of |to - from| - radius, where that is sure, and always.
inline std::optional<Sign> sign_of_distance(const double* from, const double* to, double radius) {
  const double way[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  return sign_of_reach(way, radius);
}
Sign sign_of_distance_exact(const double* from, const double* to, double radius);

/// Likewise for radius_a + radius_b, which the first rounds within its bound.
inline std::optional<Sign> sign_of_distance(const double* from, const double* to, double radius_a,
                                            double radius_b) {
  return sign_of_distance(from, to, radius_a + radius_b);
}
Sign sign_of_distance_exact(const double* from, const double* to, double radius_a, double radius_b);

}  // namespace graze::narrowphase

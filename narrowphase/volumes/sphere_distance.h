#pragma once

// How far is it from a centre to a point, seen from a radius: what all tests of spheres are made
// of. Points are arrays of three finite doubles, radii finite and not negative.

#include <graze/bvh/aabb.h>
#include <graze/narrowphase/predicates.h>
#include <array>
#include <optional>

namespace graze::narrowphase {

/// The point of the solid box nearest to `point`, exactly: each coordinate is one of the inputs.
std::array<double, 3> nearest_point(const Aabb& box, const double* point);

/// The sign of |way|^2 - radius^2 where that is sure, from the components of the way, each off by
/// one rounding at most, and the radius, likewise.
std::optional<Sign> sign_of_reach(const double* way, double radius);

/// The sign of |to - from| - radius, where that is sure, and always.
std::optional<Sign> sign_of_distance(const double* from, const double* to, double radius);
Sign sign_of_distance_exact(const double* from, const double* to, double radius);

/// Likewise for radius_a + radius_b, which the first rounds within its bound.
std::optional<Sign> sign_of_distance(const double* from, const double* to, double radius_a,
                                     double radius_b);
Sign sign_of_distance_exact(const double* from, const double* to, double radius_a, double radius_b);

}  // namespace graze::narrowphase

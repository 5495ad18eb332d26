#pragma once

#include <graze/bvh/sphere.h>
#include <Eigen/Core>
#include <span>

namespace graze {

// The fits throw InputError for no points, for the first that is not finite, and for points so
// far apart that the radius overflows. The spheres contain the points in exact arithmetic: the
// radius is rounded up, by at most 2^-48 of itself. The centre lies in the points' bounds and is a
// point of doubles: far from the origin its rounding costs radius. Points scaled by a power of two
// give the sphere scaled, as long as no coordinate or difference of coordinates is denormal or
// overflows.

/// Returns a sphere of a radius that is 5 to 20 per cent larger than need be, seldom more. It takes
/// linear time, few passes (Ritter, "An efficient bounding sphere", Graphics Gems, 1990).
Sphere ritter_sphere(std::span<const Eigen::Vector3d> points);

/// Returns the smallest sphere, up to about 1e-14 of its radius and the rounding of its centre;
/// never a larger one than Ritter's. It takes linear time in practice, some ten passes, and is
/// deterministic (Welzl, "Smallest enclosing disks (balls and ellipsoids)", 1991; the pivoting of
/// Gärtner, "Fast and robust smallest enclosing balls", 1999).
Sphere bounding_sphere(std::span<const Eigen::Vector3d> points);

/// Returns the smallest sphere around both, rounded outward: if one surely contains the other, that
/// one. Throws InputError, naming it, for a sphere that is not valid, or if the radius overflows.
Sphere merged(const Sphere& sphere_a, const Sphere& sphere_b);

}  // namespace graze

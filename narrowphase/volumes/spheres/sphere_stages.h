#pragma once

#include <graze/narrowphase/predicates/verdict.h>
#include <graze/narrowphase/volumes/ellipsoid_box.h>
#include <graze/narrowphase/volumes/hollow_overlap.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>

// The stages of intersects() and contains() for spheres, hollow volumes and ellipsoids.

namespace graze::narrowphase {

/// Returns what intersects() answers for valid spheres, with the stage that decided. Does not check
/// them.
Decision decide(const Sphere& sphere_a, const Sphere& sphere_b);

/// Returns what contains() answers for a valid sphere, with the stage that decided. Does not check
/// it.
Decision decide_contains(const Sphere& sphere, const Eigen::Vector3d& point);

/// Returns what intersects() answers for valid volumes, with the stage that decided. Does not check
/// them.
Decision decide(const Sphere& sphere, const Aabb& box);

// These functions answer the same by three methods, which differ in speed and in how often rounded
// arithmetic suffices, never in the answer. All add up, axis by axis, the square of the distance
// from the centre to the box.

/// Decides by Arvo's method for closed volumes, "A simple method for box-sphere intersection
/// testing", Graphics Gems, 1990.
Decision decide_arvo(const Sphere& sphere, const Aabb& box);

/// Rejects as soon as the distance along one axis exceeds the radius: Larsson, Akenine-Möller,
/// Lengyel, "On faster sphere-box overlap testing", Journal of Graphics Tools 12(1), 2007.
Decision decide_quick_rejections(const Sphere& sphere, const Aabb& box);

/// Computes without branches: e = max(min - c, 0) + max(c - max, 0); from the same paper.
Decision decide_branch_free(const Sphere& sphere, const Aabb& box);

/// Returns what intersects() answers for valid volumes, with the stage that decided. Does not check
/// them.
Decision decide(const Sphere& sphere, const HollowAabb& box);
Decision decide(const HollowSphere& sphere, const Aabb& box);
Decision decide(const HollowSphere& sphere, const HollowAabb& box);

/// Returns what intersects() answers for valid volumes, with the stage that decided. Does not check
/// them.
Decision decide(const Ellipsoid& ellipsoid, const Aabb& box);

}  // namespace graze::narrowphase

#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/kdop.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/sphere.h>
#include <graze/narrowphase/triangle.h>

#include <span>

namespace graze {

// The volumes of bvh/fit around triangles: what these contain, and what they cost, is said there.
// All throw InputError for no triangles, for the first with a coordinate that is not finite, and
// where the volume overflows.

/// As the function of this name that takes points, of all corners.
Aabb bounding_aabb(std::span<const Triangle> triangles);
Sphere ritter_sphere(std::span<const Triangle> triangles);
Sphere bounding_sphere(std::span<const Triangle> triangles);
KDop<18> bounding_kdop(std::span<const Triangle> triangles);
Obb ditetrahedron_box(std::span<const Triangle> triangles);
Obb bounding_obb(std::span<const Triangle> triangles);

/// Along the principal axes of the triangles' surface, so that it does not matter how finely which
/// part of it is divided; of their corners, if no triangle has area. Linear time (Gottschalk,
/// "Collision queries using oriented bounding boxes", 2000).
Obb covariance_box(std::span<const Triangle> triangles);

}  // namespace graze

#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/kdop.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/sphere.h>
#include <graze/narrowphase/triangle.h>

#include <span>

namespace graze {

// These functions fit the volumes of bvh/fit around triangles; what the volumes contain and cost is
// said there. All throw InputError for no triangles, for the first with a coordinate that is not
// finite, and where the volume overflows.

/// Calls the function of this name that takes points, with the corners of all triangles.
Aabb bounding_aabb(std::span<const Triangle> triangles);
Sphere ritter_sphere(std::span<const Triangle> triangles);
Sphere bounding_sphere(std::span<const Triangle> triangles);
KDop<18> bounding_kdop(std::span<const Triangle> triangles);
Obb ditetrahedron_box(std::span<const Triangle> triangles);
Obb bounding_obb(std::span<const Triangle> triangles);

/// Returns a box along the principal axes of the triangles' surface, so that it does not matter how
/// finely any part of it is divided, or along those of their corners if no triangle has area. Takes
/// linear time (Gottschalk, "Collision queries using oriented bounding boxes", 2000).
Obb covariance_box(std::span<const Triangle> triangles);

}  // namespace graze

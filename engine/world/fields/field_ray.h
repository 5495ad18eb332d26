#pragma once

// Casts rays at height fields. Private to engine/world.

#include <graze/bvh/pose.h>
#include <graze/bvh/ray.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/work.h>
#include <graze/engine/world/height_field.h>

#include <optional>

namespace graze {

/// Returns cast_ray() of the field's mesh, whose triangles have the field's numbers. The ray and
/// the pose must have been checked.
std::optional<RayHit> cast_at_field(const HeightField& field, const Pose& pose, const Ray& ray,
                                    Work& work);

}  // namespace graze

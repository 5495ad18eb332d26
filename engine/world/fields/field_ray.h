#pragma once

// What a ray meets of a height field. Private to engine/world.

#include <graze/bvh/pose.h>
#include <graze/bvh/ray.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/work.h>
#include <graze/engine/world/height_field.h>

#include <optional>

namespace graze {

/// As cast_ray() of the field's mesh, whose triangles have the field's numbers. Of a ray and a pose
/// that were checked.
std::optional<RayHit> cast_at_field(const HeightField& field, const Pose& pose, const Ray& ray,
                                    Work& work);

}  // namespace graze

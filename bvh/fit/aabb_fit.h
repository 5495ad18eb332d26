#pragma once

#include <graze/bvh/aabb.h>
#include <Eigen/Core>
#include <span>

namespace graze {

/// Returns the smallest box around the points, exactly, in linear time. Throws InputError if there
/// is none, or for the first that is not finite.
Aabb bounding_aabb(std::span<const Eigen::Vector3d> points);

/// Returns the smallest box around both, exactly. Both must be valid.
Aabb merged(const Aabb& box_a, const Aabb& box_b);

}  // namespace graze

#pragma once

#include <graze/bvh/aabb.h>
#include <Eigen/Core>
#include <span>

namespace graze {

/// The smallest box around the points, exactly. Throws InputError if there is none, or for the
/// first that is not finite. Linear time.
Aabb bounding_aabb(std::span<const Eigen::Vector3d> points);

/// The smallest box around both, exactly. Both must be valid.
Aabb merged(const Aabb& box_a, const Aabb& box_b);

}  // namespace graze

#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/kdop.h>
#include <graze/bvh/obb.h>
#include <Eigen/Core>

namespace graze {

// All functions below throw InputError (or PoseError, for an oriented box) for a bad volume or a
// point that is not finite.

/// True if and only if the point lies in the closed box: exact.
bool contains(const Aabb& box, const Eigen::Vector3d& point);

/// True if and only if the closed box `outer` holds all of `inner`: exact.
bool contains(const Aabb& outer, const Aabb& inner);

/// True if and only if the point, taken into the box's frame as law 3 says (q = p - t, then
/// ((R_0i q_x + R_1i q_y) + R_2i q_z), each operation rounded to double), lies in
/// [-half_extents, half_extents]. Throws InputError as well if the point overflows on its way.
bool contains(const Obb& box, const Eigen::Vector3d& point);

/// True if and only if the point lies in the closed k-DOP: exact, sums of its coordinates included.
bool contains(const KDop<18>& kdop, const Eigen::Vector3d& point);

}  // namespace graze

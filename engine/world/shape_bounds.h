#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

namespace graze {

/// A box around the shape in a pose, in the world's frame, metres: rounded outward, and tight but
/// for rounding (a few ulp of the shape's size and its coordinates), with two exceptions. A mesh's
/// is the box around its own box as that is turned, so that the cost does not depend on the mesh. A
/// half-space reaches to the largest doubles wherever no coordinate axis bounds it. O(vertices) for
/// a hull. Throws PoseError for a pose that is refused by law 10, or that moves the shape beyond
/// kLargestLength.
Aabb bounds_of(const Shape& shape, const Pose& pose);

/// Throws as bounds_of() does; what() begins with `what`.
void check_pose(const Pose& pose, const char* what);

}  // namespace graze

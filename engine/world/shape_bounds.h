#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/pose.h>
#include <graze/engine/world/placed_shape.h>

namespace graze {

/// A box around the shape in a pose, in the world's frame, metres: rounded outward, and tight but
/// for rounding (2^-44 of the shape's size, an ulp of its coordinates) and for what the pose
/// deviates from a rotation: it holds the shape by every reading of law 3, and distance() never
/// says less than two boxes are apart. There are two exceptions. That of a mesh or a height
/// field is the box around its own box as that is turned, so that the cost does not depend on it. A
/// half-space reaches to the largest doubles wherever no coordinate axis bounds it. O(vertices) for
/// a hull. Throws PoseError for a pose that is refused by law 10, or that moves the shape beyond
/// kLargestLength.
Aabb bounding_aabb(const PlacedShapeView& shape);

/// How far apart two boxes are along the axis along which that is most, metres, rounded down, and
/// the axis; 0 only if they share a point.
struct BoxGap {
  double gap = 0;           ///< metres
  int axis = 0;             ///< 0, 1 or 2: x, y or z
  bool is_a_below = false;  ///< A lies on the negative side

  bool operator==(const BoxGap&) const = default;
};
/// How far apart two valid boxes are. Nothing is checked.
BoxGap gap_between(const Aabb& a, const Aabb& b);

/// Throws as bounding_aabb() does; what() begins with `what`.
/// Returns the pose's deviation from a rotation.
double check_pose(const Pose& pose, const char* what);

}  // namespace graze

#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/pose.h>
#include <graze/engine/world/placed_shape.h>

namespace graze {

/// Returns a box around the shape in a pose, in the world's frame, metres. It is rounded outward,
/// and tight but for rounding (2^-44 of the shape's size, an ulp of its coordinates) and for how
/// far the pose deviates from a rotation: it holds the shape by every reading of law 3, and no
/// distance() is less than the distance of the two boxes. There are two exceptions. The box of a
/// mesh or a height field is the one around its own box after that is turned, so that the cost does
/// not depend on the number of triangles. The box of a half-space reaches to the largest doubles
/// wherever no coordinate axis bounds it. The cost is O(1), and O(vertices) for a hull. Throws
/// PoseError for a pose that is refused by law 10, or that moves the shape beyond kLargestLength.
Aabb bounding_aabb(const PlacedShapeView& shape);

/// The gap between two boxes along the axis on which it is largest, and that axis. The gap is
/// rounded down, and 0 only if the boxes share a point.
struct BoxGap {
  double gap = 0;           ///< metres
  int axis = 0;             ///< 0, 1 or 2: x, y or z
  bool is_a_below = false;  ///< true if A lies on the negative side

  bool operator==(const BoxGap&) const = default;
};
/// Returns the gap between two boxes, which must be valid: nothing is checked.
BoxGap gap_between(const Aabb& a, const Aabb& b);

/// Returns the pose's deviation from a rotation. Throws as bounding_aabb() does; what() begins with
/// `what`.
double check_pose(const Pose& pose, const char* what);

}  // namespace graze

#pragma once

#include <graze/bvh/pose.h>
#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/value/local_frame.h>

namespace graze {

/// A tree's frame in a pose, which outlives it, and the numbers from which the slack of a query is
/// derived.
struct PlacedFrame {
  /// Takes `pose_deviation`, the deviation from a rotation as check_rigid() returns it, and
  /// `bounds`, those of the primitives (metres).
  PlacedFrame(const Pose& pose, double pose_deviation, const bvh::LocalFrame& tree_frame,
              const Aabb& bounds);

  const double* m;               ///< the pose, column-major 4x4
  const bvh::LocalFrame& frame;  ///< the frame of the tree
  double deviation;              ///< the deviation with the rounding of its measurement
  double radius;                 ///< the radius of the frame, metres
  double largest;                ///< the largest coordinate of the primitives
  double placing;                ///< the error of rounding a placed coordinate
  double centre[3];              ///< the placed centre of the frame
};

/// Returns how frame B lies in frame A, with the one slack of the query (law 5): node boxes that
/// are further apart than it hold no two primitives that intersect when placed by law 1; nor, when
/// B is an oriented box, does a placed triangle in A meet it by law 3.
bvh::RelativeFrame relative_frame(const PlacedFrame& a, const PlacedFrame& b);

/// Returns relative_frame(b, a), bit for bit, in less time.
bvh::RelativeFrame reversed(const bvh::RelativeFrame& b_in_a, const PlacedFrame& a,
                            const PlacedFrame& b);

}  // namespace graze

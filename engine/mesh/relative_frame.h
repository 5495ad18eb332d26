#pragma once

#include <graze/bvh/box_separation.h>
#include <graze/bvh/local_frame.h>
#include <graze/bvh/pose.h>

namespace graze {

/// A tree's frame in a pose, with what is known of its contents.
struct PlacedFrame {
  const Pose& pose;
  double deviation;              ///< of the pose from a rotation, as check_rigid() returns it
  const bvh::LocalFrame& frame;  ///< of the tree
  const Aabb& bounds;            ///< of the primitives, metres
};

/// How frame B lies in frame A, with the one slack of the query (law 5): node boxes that are
/// further apart than it hold no two primitives that intersect when placed by law 1; nor, when B is
/// an oriented box, does a placed triangle in A meet it by law 3.
bvh::RelativeFrame relative_frame(const PlacedFrame& a, const PlacedFrame& b);

/// relative_frame(b, a), bit for bit, in less time.
bvh::RelativeFrame reversed(const bvh::RelativeFrame& b_in_a, const PlacedFrame& a,
                            const PlacedFrame& b);

}  // namespace graze

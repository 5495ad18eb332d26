#pragma once

// How far parts of a body are from something else, at least. Private to engine/world.

#include <graze/bvh/aabb.h>
#include <graze/bvh/pose.h>

namespace graze {

/// A box of a body's own frame in the world, as law 3 reads poses: outward.
struct BoxPlacing {
  const Pose& pose;
  double room;  ///< for what is rounded, and how poses deviate from rotations, metres

  Aabb operator()(const Aabb& own) const;
};

/// Of shapes in a box of the world, and parts in boxes of a body's frame. The diagonal of the one,
/// and a length that no part is wider than, say how coarse distances may be.
class GapToParts {
 public:
  GapToParts(const Aabb& box, const BoxPlacing& placing, double widest_part);

  /// distance() says no less than this of a shape in the box and a part in that box, if its search
  /// converges: metres.
  double to_box(const Aabb& world) const;
  double to_own(const Aabb& own) const { return to_box(placing_(own)); }

 private:
  Aabb box_;
  BoxPlacing placing_;
  double lengths_;
};

}  // namespace graze

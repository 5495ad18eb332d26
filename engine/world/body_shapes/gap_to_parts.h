#pragma once

// How far parts of a body are from something else, at least. Private to engine/world.

#include <graze/bvh/aabb.h>
#include <graze/bvh/pose.h>
#include <graze/engine/world/placed_shape.h>

#include <functional>

namespace graze {

/// A box of a body's own frame in the world, as law 3 reads poses: outward.
struct BoxPlacing {
  const Pose& pose;
  double room;  ///< for what is rounded, and how poses deviate from rotations, metres

  Aabb operator()(const Aabb& own) const;
};

/// What the nearest part of a body is looked for to.
struct PartSeeker {
  const Aabb& box;                         ///< in the world, around all of it
  double search_radius;                    ///< metres: parts farther from the box are of no use
  double limit;                            ///< likewise parts that are farther from it
  const PlacedShapeView* shape = nullptr;  ///< if it is one
  /// If it has parts itself: none is nearer to a box than this says, if that is no more than the
  /// limit, and else than the limit.
  const std::function<double(const PlacedShapeView& box, double limit)>* gap_to_box = nullptr;
};

/// How far a seeker is from parts in boxes of a body's frame. The diagonal of its box, and a length
/// that no part is wider than, say how coarse distances may be.
class GapToParts {
 public:
  GapToParts(const PartSeeker& seeker, const BoxPlacing& placing, double widest_part);

  /// distance() says no less than this of what is sought for and a part in that box, if its search
  /// converges: metres.
  double to_box(const Aabb& world) const;
  double to_own(const Aabb& own) const { return to_box(placing_(own)); }
  /// The same, as near as it can be known: by the distance of a shape, or of parts, and the box. Of
  /// parts that are farther than a limit only this.
  double measured(const Aabb& own, double limit) const;

 private:
  double sure(double apart) const;

  PartSeeker seeker_;
  BoxPlacing placing_;
  double lengths_;
};

}  // namespace graze

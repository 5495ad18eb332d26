#pragma once

// Bounds how far parts of a body are from something else. Private to engine/world.

#include <graze/bvh/aabb.h>
#include <graze/bvh/pose.h>
#include <graze/engine/world/placed_shape.h>

#include <functional>

namespace graze {

/// Takes a box of a body's own frame to the world, outward, as law 3 reads poses.
struct BoxPlacing {
  const Pose& pose;
  double room;  ///< room for rounding and for how poses deviate from rotations, metres

  Aabb operator()(const Aabb& own) const;
};

/// The seeker of the nearest part of a body.
struct PartSeeker {
  const Aabb& box;                         ///< a box in the world around the whole seeker
  double search_radius;                    ///< metres: parts that are farther from the box do not
                                           ///< count
  double limit;                            ///< metres: parts that are farther from the seeker do
                                           ///< not count
  const PlacedShapeView* shape = nullptr;  ///< the seeker, if it is a shape
  /// For a seeker with parts of its own: none of them is nearer to a box than this returns, if that
  /// is at most the limit, and else none is nearer than the limit.
  const std::function<double(const PlacedShapeView& box, double limit)>* gap_to_box = nullptr;
};

/// Bounds how far a seeker is from parts in boxes of a body's frame. The diagonal of its box, and a
/// length that no part is wider than, bound the errors of distances.
class GapToParts {
 public:
  GapToParts(const PartSeeker& seeker, const BoxPlacing& placing, double widest_part);

  /// Returns a length, metres, such that distance() of the seeker and a part in that box is no
  /// less, if its search converges.
  double to_box(const Aabb& world) const;
  double to_own(const Aabb& own) const { return to_box(placing_(own)); }
  /// Returns such a bound that is as good as possible: it measures the distance of the box from the
  /// seeker's shape, or from its parts. If its parts are all farther than the limit, it says only
  /// that.
  double measured(const Aabb& own, double limit) const;

 private:
  double sure(double apart) const;

  PartSeeker seeker_;
  BoxPlacing placing_;
  double lengths_;
};

}  // namespace graze

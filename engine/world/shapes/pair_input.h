#pragma once

// Puts pairs in canonical order, so that swapping A and B changes nothing but names (law 4).
// Private to engine/world.

#include <graze/bvh/pose.h>
#include <graze/engine/work.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/shape.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/narrowphase/convex/gap/core_gap.h>

#include <limits>

namespace graze {

/// True if B goes first: the lower kind goes first, and of equal kinds the one whose pose, or else
/// whose numbers, come first.
bool is_swapped(const PlacedShapeView& a, const PlacedShapeView& b);

/// Returns intersects() for shapes whose bounding_aabb() share a point, in poses that were checked.
/// For other shapes it may say "hit" where a tolerance brings two together and their boxes part
/// them.
bool intersect_in_boxes(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);

/// Return intersects() and distance() of shapes in poses that were checked, neither of which is a
/// height field or a plane.
bool intersect_checked(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);
ShapeDistance distance_of_checked(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);

/// Writes find_contacts() of shapes as intersect_in_boxes() takes them to `found`, whose memory is
/// used again.
void contacts_in_boxes(const PlacedShapeView& a, const PlacedShapeView& b, Work& work,
                       Manifold& found);

/// Throws unless both poses are fit for shapes.
void check_poses(const Pose& pose_a, const Pose& pose_b);

/// Returns the distance with A and B swapped.
ShapeDistance mirrored(ShapeDistance found);

/// The gap of two sets, computed from that of their cores.
struct SetGap {
  bool is_apart;
  double distance;  ///< 0 unless apart
  double lower;
  narrowphase::Vec3 point_a;
  narrowphase::Vec3 point_b;
  narrowphase::Vec3 normal;
  PairStatus status;
};
/// Returns the gap of two sets. If they are further apart than `limit`, metres, only that need be
/// proved.
SetGap gap_of_sets(const narrowphase::Core& a, const narrowphase::Core& b,
                   double limit = std::numeric_limits<double>::infinity());
/// Returns the gap of two sets, from a gap of their cores that was found otherwise.
SetGap set_gap(const narrowphase::Core& a, const narrowphase::Core& b,
               const narrowphase::CoreGap& gap);
bool are_apart(const narrowphase::Core& a, const narrowphase::Core& b, PairStatus& status);

}  // namespace graze

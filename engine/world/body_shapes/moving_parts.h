#pragma once

// Parts of bodies that move. Private to engine/world.

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/world/body_shapes/part_pairs.h>

#include <algorithm>
#include <vector>

namespace graze {

/// A body's shape and its motion.
struct MovingBodyShape {
  const BodyShape& shape;
  const RigidMotion& motion;
  std::optional<Filter> filter = {};  ///< the filter of the body, if it is known
};

/// A part that moves with its body; or a shape that is no compound, as its own part 0.
struct MovingPart {
  PlacedPart placed;  ///< the part at the start
  RigidMotion motion;
  Aabb swept;  ///< a box around all its places
};

/// Returns a box around all places of a shape. Of a user's own shape only its bounding radius is
/// known. Throws PoseError where numbers could overflow.
Aabb swept_box(const BodyShape& shape, const RigidMotion& motion);

/// Returns the parts of a body whose boxes around all places meet a box; ascending. Throws as
/// swept_box() does.
std::vector<MovingPart> moving_parts_in(const MovingBodyShape& body, const Aabb& box);

/// Calls `visit(part_a, part_b)` for parts that may come as near to each other as the settings ask
/// for, by their numbers ascending. Throws as swept_box() does.
template <typename Visit>
void for_moving_part_pairs(const MovingBodyShape& a, const MovingBodyShape& b,
                           const RigidContactSettings& settings, const Visit& visit) {
  const double room = settings.clearance + settings.tolerance;
  const std::vector<MovingPart> parts_a =
      moving_parts_in(a, grown(swept_box(b.shape, b.motion), room));
  for (const MovingPart& part_a : parts_a) {
    for (const MovingPart& part_b : moving_parts_in(b, grown(part_a.swept, room))) {
      if (do_parts_meet({a.shape, a.motion.start(), 0, a.filter}, part_a.placed,
                        {b.shape, b.motion.start(), 0, b.filter}, part_b.placed))
        visit(part_a, part_b);
    }
  }
}

/// Returns BodyShape::first_contact() of the two.
RigidContact first_contact_of(const MovingPart& a, const MovingPart& b,
                              const RigidContactSettings& settings);

}  // namespace graze

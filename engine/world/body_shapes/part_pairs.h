#pragma once

// Finds pairs of parts of two bodies, each of which may be a compound. Private to engine/world.

#include <graze/engine/world/body_shapes/parts_body.h>
#include <graze/engine/world/contacts/margin/nearness.h>
#include <graze/engine/world/shapes/grown_box.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

namespace graze {

/// A body's shape in its pose.
struct PosedBody {
  const BodyShape& shape;
  const Pose& pose;
  double room = 0;                    ///< the room around its box, or around that of each of its
                                      ///< parts, metres
  std::optional<Filter> filter = {};  ///< the filter of the body, if it is known
  bool has_filters = true;            ///< if false, the filters of its parts do not count, either
};

/// Returns the parts of a body whose boxes, with its room, meet a box in the world; ascending.
std::vector<PlacedPart> parts_near(const PosedBody& body, const Aabb& box);

/// True if the filters of two parts, or those of their bodies where the parts have none, let them
/// meet. The filters of the bodies themselves are tested before.
bool do_parts_meet(const PosedBody& a, const PlacedPart& part_a, const PosedBody& b,
                   const PlacedPart& part_b);

/// Returns the box that the broad phase has of a body.
Aabb box_with_room(const PosedBody& body);

/// Calls `visit(part)` for the parts that parts_near() returns until it returns false. Returns
/// false then.
bool visit_parts_near(const PosedBody& body, const Aabb& box,
                      const std::function<bool(const PlacedPart&)>& visit);

/// Calls `visit(part_a, part_b)` for the parts that may meet, by their numbers ascending, until it
/// returns false.
template <typename Visit>
void for_part_pairs(const PosedBody& a, const PosedBody& b, const Visit& visit) {
  const bool is_b_whole = as_parts(b.shape) == nullptr;
  const Aabb box_b = box_with_room(b);
  std::vector<PlacedPart> whole_b;
  if (is_b_whole) whole_b = parts_near(b, box_b);
  const auto visit_a = [&](const PlacedPart& part_a) {
    const auto visit_b = [&](const PlacedPart& part_b) {
      return !do_parts_meet(a, part_a, b, part_b) || visit(part_a, part_b);
    };
    if (is_b_whole) return std::all_of(whole_b.begin(), whole_b.end(), visit_b);
    return visit_parts_near(b, a.room > 0 ? grown(part_a.box, a.room) : part_a.box,
                            std::cref(visit_b));
  };
  visit_parts_near(a, box_b, std::cref(visit_a));  // references, so that nothing is allocated
}

/// Returns the nearness of two parts, as that of two bodies of their own.
Nearness nearness_of(const PlacedPart& a, const PlacedPart& b, const ManifoldSettings& settings);

/// Returns the nearness of two parts, and replaces what `found` held by their contacts: none if
/// they are apart.
Nearness contacts_of(const PlacedPart& a, const PlacedPart& b, const ManifoldSettings& settings,
                     Manifold& found);

/// The distance of a part, B, from a shape, A.
struct PartDistance {
  ShapeDistance distance;
  std::uint32_t part = 0;
};
/// Returns the nearest part that may meet the shape and is not farther than `most`, metres; of
/// equal distances that of the least number. The pose must have been checked.
std::optional<PartDistance> nearest_part(const PlacedShapeView& shape, const PartsBody& whole,
                                         const Pose& pose, double most,
                                         const std::function<bool(const PlacedPart&)>& may_meet);

/// Returns a length, metres, such that no part is nearer to a shape than that, if it is at most
/// `most`, and else none is nearer than `most`. The pose must have been checked.
double least_gap(const PlacedShapeView& shape, const PartsBody& whole, const Pose& pose,
                 double most);

}  // namespace graze

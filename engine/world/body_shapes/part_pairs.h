#pragma once

// Pairs of parts of two bodies, of which each may be a compound. Private to engine/world.

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
  double room = 0;                    ///< metres around its box, or that of each of its parts
  std::optional<Filter> filter = {};  ///< the body's, if it is known
  bool has_filters = true;            ///< false: those of its parts mean nothing, either
};

/// Its parts whose boxes, with its room, meet a box in the world; ascending.
std::vector<PlacedPart> parts_near(const PosedBody& body, const Aabb& box);

/// Whether the filters of two parts, or those of their bodies where these have none, let them meet.
/// Those of the bodies themselves are asked before.
bool do_parts_meet(const PosedBody& a, const PlacedPart& part_a, const PosedBody& b,
                   const PlacedPart& part_b);

/// The box that the broad phase has of it.
Aabb box_with_room(const PosedBody& body);

/// Calls `visit(part)` for these until it returns false. False then.
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
  visit_parts_near(a, box_b, std::cref(visit_a));  // references: nothing is allocated
}

/// How two parts stand to each other, as two bodies of their own would.
Nearness nearness_of(const PlacedPart& a, const PlacedPart& b, const ManifoldSettings& settings);

/// The same with their contacts, in the place of what `found` held: none if they are apart.
Nearness contacts_of(const PlacedPart& a, const PlacedPart& b, const ManifoldSettings& settings,
                     Manifold& found);

/// How far a part is from a shape that is A.
struct PartDistance {
  ShapeDistance distance;
  std::uint32_t part = 0;
};
/// The nearest part that may meet it and is not farther than `most`, metres; of equal distances
/// that of the least number. Of a pose that was checked.
std::optional<PartDistance> nearest_part(const PlacedShapeView& shape, const PartsBody& whole,
                                         const Pose& pose, double most,
                                         const std::function<bool(const PlacedPart&)>& may_meet);

/// No part is nearer to a shape than this, metres, if it is no more than `most`, and else than
/// `most`. Likewise.
double least_gap(const PlacedShapeView& shape, const PartsBody& whole, const Pose& pose,
                 double most);

}  // namespace graze

// Finds which bodies touch or are near a shape that is no body's own.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/bvh/value/number_text.h>
#include <graze/engine/world/bodies/nearest_bodies.h>
#include <graze/engine/world/bodies/world_state.h>
#include <graze/engine/world/body_shapes/part_pairs.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/narrowphase/volumes/aabb_overlap.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace graze {
namespace {

bool do_touch_any_part(const PosedBody& a, const PosedBody& b) {
  bool do_touch = false;
  for_part_pairs(a, b, [&](const PlacedPart& s, const PlacedPart& t) {
    do_touch = nearness_of(s, t, {}) == Nearness::Touching;
    return !do_touch;
  });
  return do_touch;
}

bool is_nearer(const BodyDistance& s, const BodyDistance& t) {
  if (s.distance.distance != t.distance.distance) return s.distance.distance < t.distance.distance;
  return s.id < t.id;
}

}  // namespace

bool World::State::is_asked_for(std::uint32_t index, const BodyQuerySettings& query) const {
  const Bodies::Body& body = all.bodies[index];
  if (query.filter && !lets_pass(*query.filter, body.filter)) return false;
  return !query.role || *query.role == body.role;
}

std::vector<std::uint32_t> World::State::find_bodies(const Aabb& box,
                                                     const BodyQuerySettings& query) const {
  std::vector<std::uint32_t> bodies;
  broad.find_overlapping(box, bodies);
  for (std::uint32_t& index : bodies)
    index = body_of_box[index];
  // Boxes have room for margins, which do not count here.
  std::erase_if(bodies, [&](std::uint32_t index) {
    const Bodies::Body& body = all.bodies[index];
    return body.room() > 0 &&
           !intersects(box, body.ask([&](const BodyShape& s) { return s.bounds(body.pose); }));
  });
  std::erase_if(bodies, [&](std::uint32_t index) { return !is_asked_for(index, query); });
  std::sort(bodies.begin(), bodies.end());
  return bodies;
}

/// Returns the distance of a body, or nothing for a compound without a part within `most` metres
/// that is asked for.
std::optional<BodyDistance> World::State::distance_to(std::uint32_t index,
                                                      const PlacedShapeView& placed,
                                                      const BodyQuerySettings& query,
                                                      double most) const {
  const Bodies::Body& body = all.bodies[index];
  if (const PartsBody* whole = as_parts(*body.shape)) {
    const auto found = nearest_part(placed, *whole, body.pose, most, [&](const PlacedPart& part) {
      return lets_part_meet(part.filter, query.filter);
    });
    if (!found) return std::nullopt;
    return BodyDistance{all.id(index), found->distance, found->part};
  }
  if (body.shape->shape() == nullptr) {
    throw UnsupportedPairError("distance of a " + std::string(name_of(placed.shape.kind())) +
                                   " and the body with index " + std::to_string(index) +
                                   ": its shape is a user's own",
                               {.element = "body", .index = index});
  }
  return BodyDistance{all.id(index), distance(placed, {*body.shape->shape(), body.pose})};
}

bool World::State::asks_for_any(const BodyQuerySettings& query) const {
  for (std::uint32_t index = 0; index < all.bodies.size(); ++index) {
    if (all.ids.is_live(index) && is_asked_for(index, query)) return true;
  }
  return false;
}

std::vector<BodyId> World::find_in_box(const Aabb& box, const BodyQuerySettings& settings) const {
  return bvh::in_standard_arithmetic([&]() -> std::vector<BodyId> {
    bvh::check_box(box, "find_in_box");
    std::vector<BodyId> bodies;
    for (const std::uint32_t index : state_->find_bodies(box, settings))
      bodies.push_back(state_->all.id(index));
    return bodies;
  });
}

std::vector<BodyId> World::find_touching(const PlacedShapeView& placed,
                                         const BodyQuerySettings& settings) const {
  return bvh::in_standard_arithmetic([&]() -> std::vector<BodyId> {
    const Shape& shape = placed.shape;
    const Pose& pose = placed.pose;
    const State& state = *state_;
    const std::shared_ptr<const BodyShape> asked = share(shape);
    std::vector<BodyId> touching;
    for (const std::uint32_t index : state.find_bodies(bounding_aabb({shape, pose}), settings)) {
      const Bodies::Body& body = state.all.bodies[index];
      const bool is_hit = body.has_parts
                              ? do_touch_any_part({*asked, pose, 0, settings.filter},
                                                  {*body.shape, body.pose, 0, body.filter})
                              : asked->touches(pose, *body.shape, body.pose);
      if (is_hit) touching.push_back(state.all.id(index));
    }
    return touching;
  });
}

std::vector<BodyDistance> World::find_within(const PlacedShapeView& placed, double clearance,
                                             const BodyQuerySettings& settings) const {
  return bvh::in_standard_arithmetic([&]() -> std::vector<BodyDistance> {
    const Shape& shape = placed.shape;
    const Pose& pose = placed.pose;
    if (!(clearance >= 0 && clearance <= kLargestDistance))
      throw InputError("find_within: the clearance is " + bvh::number_text(clearance) +
                       ", but must be finite and not negative");
    const State& state = *state_;
    std::vector<BodyDistance> near;
    const Aabb box = grown(bounding_aabb({shape, pose}), clearance);
    for (const std::uint32_t index : state.find_bodies(box, settings)) {
      const auto found = state.distance_to(index, placed, settings, clearance);
      if (found && found->distance.distance <= clearance) near.push_back(*found);
    }
    return near;
  });
}

std::optional<BodyDistance> World::find_closest(const PlacedShapeView& placed,
                                                const BodyQuerySettings& settings) const {
  return bvh::in_standard_arithmetic([&]() -> std::optional<BodyDistance> {
    const Aabb own = bounding_aabb(placed);
    std::optional<BodyDistance> best;
    if (!state_->asks_for_any(settings)) return best;
    state_->for_nearest({own, placed.pose}, settings, kBeyondAll, [&](std::uint32_t index) {
      const auto next = state_->distance_to(index, placed, settings, kLargestDistance);
      if (next && (!best || is_nearer(*next, *best))) best = next;
      return best ? best->distance.distance : kBeyondAll;
    });
    return best;
  });
}

}  // namespace graze

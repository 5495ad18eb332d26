// Finds the bodies to which a shape in rigid motion comes.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/world/bodies/world_state.h>
#include <graze/engine/world/body_shapes/moving_parts.h>
#include <graze/engine/world/rigid/box_sweep.h>
#include <graze/engine/world/rigid/moving_shape.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_motion.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace graze {

/// A shape in motion, and the bodies that it is asked about. All that it refers to must outlive it.
struct CastQuery {
  MovingShape moving;
  const RigidContactSettings& contact;  ///< checked
  const BodyQuerySettings& query;
};

/// A body that the shape may come to, but not before a time.
struct CastCandidate {
  std::uint32_t index;
  double first;
};

namespace {

constexpr double kNever = 2;

double size_of(const Eigen::Vector3d& v) {
  return (std::abs(v.x()) + std::abs(v.y())) + std::abs(v.z());
}

/// Returns when a shape that goes straight from a box, and does not turn, may be too near to a body
/// in another box: at other times first_contact() finds them free. Its tolerance is at least 2^-28
/// of all lengths, which the body's pose and box bound; twice that is room for the errors of
/// distances, boxes and times.
NearTimes times_near(const MovingShape& moving, const Aabb& start, const Aabb& box,
                     const Pose& pose, const RigidContactSettings& contact) {
  const double lengths =
      moving.lengths + 3 * (size_of(box.min) + size_of(box.max) + size_of(pose.translation()));
  const double room = contact.clearance + contact.tolerance + 0x1p-27 * lengths;
  const Aabb around = grown(start, room);
  BoxSweep sweep;
  for (int k = 0; k < 3; ++k) {
    sweep.min[k] = around.min.data()[k];
    sweep.max[k] = around.max.data()[k];
    sweep.shift[k] = moving.motion.shift().data()[k];
  }
  return sweep.of({box.min.x(), box.min.y(), box.min.z()}, {box.max.x(), box.max.y(), box.max.z()});
}

bool is_earlier(const BodyCast& s, const BodyCast& t) {
  if (s.contact.low != t.contact.low) return s.contact.low < t.contact.low;
  return s.id != t.id ? s.id < t.id : s.part < t.part;
}

}  // namespace

/// Returns the part of a body that the shape comes to first.
std::optional<BodyCast> World::State::cast_at_parts(std::uint32_t index,
                                                    const CastQuery& cast) const {
  const Bodies::Body& body = all.bodies[index];
  const std::shared_ptr<const BodyShape> asked = share(cast.moving.shape);
  const RigidMotion rest(body.pose);
  std::optional<BodyCast> first;
  for_moving_part_pairs({*asked, cast.moving.motion, cast.query.filter},
                        {*body.shape, rest, body.filter}, cast.contact,
                        [&](const MovingPart& s, const MovingPart& t) {
                          const RigidContact found = first_contact_of(s, t, cast.contact);
                          if (found.status == RigidStatus::Free) return;
                          const BodyCast next{all.id(index), found, t.placed.number};
                          if (!first || is_earlier(next, *first)) first = next;
                        });
  return first;
}

/// Returns the bodies that the shape may come to, each with a time before which it does not.
std::vector<CastCandidate> World::State::find_cast_candidates(const CastQuery& cast) const {
  const RigidContactSettings& contact = cast.contact;
  const double near = contact.clearance + contact.tolerance;
  std::vector<CastCandidate> found;
  for (const std::uint32_t index : find_bodies(grown(swept_bounds(cast.moving), near), cast.query))
    found.push_back({index, 0});
  if (cast.moving.turned > 0 || cast.moving.is_endless()) return found;
  const Aabb start = bounding_aabb({cast.moving.shape, cast.moving.motion.start()});
  for (CastCandidate& body : found) {
    const Aabb box = broad.box(broad.id(all.bodies[body.index].box));
    const NearTimes times =
        times_near(cast.moving, start, box, all.bodies[body.index].pose, contact);
    body.first = times.is_never() ? kNever : times.first;
  }
  std::erase_if(found, [](const CastCandidate& body) { return body.first == kNever; });
  return found;
}

/// Returns when the shape comes to a body, or nothing if it is free of it.
std::optional<BodyCast> World::State::cast_at(const CastCandidate& candidate,
                                              const CastQuery& cast) const {
  auto found = cast_at(candidate.index, cast);
  // So the order of answers is the same whichever bodies are asked.
  if (found && found->contact.is_out_of_budget)
    found->contact.low = std::max(found->contact.low, candidate.first);
  return found;
}

std::optional<BodyCast> World::State::cast_at(std::uint32_t index, const CastQuery& cast) const {
  const Bodies::Body& body = all.bodies[index];
  if (body.has_parts) return cast_at_parts(index, cast);
  const Shape* shape = body.shape->shape();
  if (shape == nullptr) {
    throw UnsupportedPairError("cast of a " + std::string(name_of(cast.moving.shape.kind())) +
                                   " at the body with index " + std::to_string(index) +
                                   ": its shape is a user's own",
                               {.element = "body", .index = index});
  }
  const RigidMotion rest(body.pose);
  Work work;
  const RigidContact found =
      contact_of_moving(cast.moving, {*shape, rest, "motion of shape B"}, cast.contact, work);
  if (found.status == RigidStatus::Free) return std::nullopt;
  return BodyCast{all.id(index), found};
}

std::vector<BodyCast> World::cast_all(const ShapeInMotion& shape,
                                      const RigidContactSettings& contact,
                                      const BodyQuerySettings& settings) const {
  return bvh::in_standard_arithmetic([&]() -> std::vector<BodyCast> {
    const CastQuery query{{shape.shape, shape.motion, "cast"}, check_settings(contact), settings};
    std::vector<BodyCast> casts;
    for (const CastCandidate& body : state_->find_cast_candidates(query)) {
      if (const auto found = state_->cast_at(body, query)) casts.push_back(*found);
    }
    std::sort(casts.begin(), casts.end(), is_earlier);
    return casts;
  });
}

std::optional<BodyCast> World::cast(const ShapeInMotion& shape, const RigidContactSettings& contact,
                                    const BodyQuerySettings& settings) const {
  return bvh::in_standard_arithmetic([&]() -> std::optional<BodyCast> {
    const CastQuery query{{shape.shape, shape.motion, "cast"}, check_settings(contact), settings};
    std::vector<CastCandidate> bodies = state_->find_cast_candidates(query);
    // The bodies that it may come to first can make asking the others needless.
    std::stable_sort(
        bodies.begin(), bodies.end(),
        [](const CastCandidate& s, const CastCandidate& t) { return s.first < t.first; });
    std::optional<BodyCast> first;
    for (const CastCandidate& body : bodies) {
      if (first && body.first > first->contact.low) break;
      const auto found = state_->cast_at(body, query);
      if (found && (!first || is_earlier(*found, *first))) first = found;
    }
    return first;
  });
}

}  // namespace graze

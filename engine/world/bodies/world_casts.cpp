// To which bodies a shape in rigid motion comes.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/world/bodies/world_state.h>
#include <graze/engine/world/body_shapes/moving_parts.h>
#include <graze/engine/world/rigid/moving_shape.h>
#include <graze/engine/world/shape_motion.h>

#include <algorithm>
#include <string>

namespace graze {
namespace {

bool is_earlier(const BodyCast& s, const BodyCast& t) {
  if (s.contact.low != t.contact.low) return s.contact.low < t.contact.low;
  return s.id != t.id ? s.id < t.id : s.part < t.part;
}

}  // namespace

/// Adds the part that the shape comes to first.
void World::State::cast_at_parts(std::uint32_t index, const Shape& shape, const RigidMotion& motion,
                                 const RigidContactSettings& contact,
                                 const BodyQuerySettings& query,
                                 std::vector<BodyCast>& casts) const {
  const Bodies::Body& body = all.bodies[index];
  const std::shared_ptr<const BodyShape> asked = share(shape);
  const RigidMotion rest(body.pose);
  std::optional<BodyCast> first;
  for_moving_part_pairs({*asked, motion, query.filter}, {*body.shape, rest, body.filter}, contact,
                        [&](const PartOnWay& s, const PartOnWay& t) {
                          const RigidContact found = first_contact_of(s, t, contact);
                          if (found.status == RigidStatus::Free) return;
                          const BodyCast next{all.id(index), found, t.placed.number};
                          if (!first || is_earlier(next, *first)) first = next;
                        });
  if (first) casts.push_back(*first);
}

std::vector<BodyCast> World::cast_all(const Shape& shape, const RigidMotion& motion,
                                      const RigidContactSettings& contact,
                                      const BodyQuerySettings& settings) const {
  return bvh::in_standard_arithmetic([&]() -> std::vector<BodyCast> {
    check_settings(contact);
    const State& state = *state_;
    const Aabb swept = swept_bounds(MovingShape(shape, motion, "cast"));
    std::vector<BodyCast> casts;
    for (const std::uint32_t index :
         state.find_bodies(grown(swept, contact.clearance + contact.tolerance), settings)) {
      const Bodies::Body& body = state.all.bodies[index];
      if (body.has_parts) {
        state.cast_at_parts(index, shape, motion, contact, settings, casts);
        continue;
      }
      if (body.shape->shape() == nullptr) {
        throw UnsupportedPairError("cast of a " + std::string(name_of(shape.kind())) +
                                   " at the body with index " + std::to_string(index) +
                                   ": its shape is a user's own");
      }
      const RigidContact found =
          first_contact(shape, motion, *body.shape->shape(), RigidMotion(body.pose), contact);
      if (found.status != RigidStatus::Free) casts.push_back({state.all.id(index), found});
    }
    std::sort(casts.begin(), casts.end(), is_earlier);
    return casts;
  });
}

std::optional<BodyCast> World::cast(const Shape& shape, const RigidMotion& motion,
                                    const RigidContactSettings& contact,
                                    const BodyQuerySettings& settings) const {
  const std::vector<BodyCast> casts = cast_all(shape, motion, contact, settings);
  if (casts.empty()) return std::nullopt;
  return casts.front();
}

}  // namespace graze

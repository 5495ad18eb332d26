#include <graze/engine/world/body_shapes/moving_parts.h>
#include <graze/engine/world/body_shapes/users_shape.h>
#include <graze/engine/world/rigid/moving_shape.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

Aabb everything() {
  const Eigen::Vector3d all = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
  return {-all, all};
}

/// Returns the motion of a part. If the body does not turn, any point may be the centre: the part's
/// own origin is taken, which is not far away.
RigidMotion part_motion(const RigidMotion& body, const Pose& start) {
  const bool does_turn = body.angle() != 0;
  return RigidMotion(start, {.centre = does_turn ? body.centre() : start.translation(),
                             .shift = body.shift(),
                             .axis = body.axis(),
                             .angle = body.angle()});
}

/// Returns a length, metres, such that no point at most `radius` from the body's origin is ever
/// farther than that from where it was at the start.
double longest_travel(const RigidMotion& motion, double radius) {
  const double farthest = length_of(motion.start().translation() - motion.centre()) + radius;
  const double travel =
      length_of(motion.shift()) + std::min(std::abs(motion.angle()), 2.0) * farthest;
  // The added terms bound how poses deviate from rotations and how places are rounded
  // (MovingShape::kStretch).
  return travel * (1 + 0x1p-16) + 0x1p-16 * (motion.angle() == 0 ? 0 : farthest) +
         0x1p-40 * (farthest + length_of(motion.centre()));
}

}  // namespace

Aabb swept_box(const BodyShape& shape, const RigidMotion& motion) {
  const bool is_users = is_users_shape(shape);
  if (const Shape* known = ask_shape(is_users, [&] { return shape.shape(); }))
    return swept_bounds(MovingShape(*known, motion, "sweep"));
  const double radius =
      std::max(ask_shape(is_users, [&] { return shape.bounding_radius(); }), kSmallestLength);
  if (!(radius <= kLargestLength)) return everything();
  const Shape ball = Sphere{Eigen::Vector3d::Zero(), radius};
  return swept_bounds(MovingShape(ball, motion, "sweep"));
}

std::vector<MovingPart> moving_parts_in(const MovingBodyShape& body, const Aabb& box) {
  std::vector<MovingPart> parts;
  const PartsBody* whole = as_parts(body.shape);
  const Pose& start = body.motion.start();
  if (whole == nullptr) {
    const Aabb swept = swept_box(body.shape, body.motion);
    if (share_a_point(swept, box))
      parts.push_back({{&body.shape, start, swept, nullptr, 0}, body.motion, swept});
    return parts;
  }
  const double travel = longest_travel(body.motion, whole->bounding_radius());
  for (PlacedPart& part : whole->near(start, grown(box, travel), 0)) {
    const RigidMotion motion = part_motion(body.motion, part.pose);
    const Aabb swept = swept_box(*part.shape, motion);
    if (share_a_point(swept, box)) parts.push_back({part, motion, swept});
  }
  return parts;
}

RigidContact first_contact_of(const MovingPart& a, const MovingPart& b,
                              const RigidContactSettings& settings) {
  const BodyShape& shape = *a.placed.shape;
  return ask_shape(is_users_shape(shape), [&] {
    return shape.first_contact(a.motion, *b.placed.shape, b.motion, settings);
  });
}

}  // namespace graze

#include <graze/engine/world/rigid/moving_stand_in.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>
#include <cmath>

namespace graze {

namespace {

// Shares of all lengths that are more than the tolerances and the rounding of motions and casts.
constexpr double kMotionRoom = 0x1p-26;
constexpr double kTurnRoom = 0x1p-42;

double sum_of(const Eigen::Vector3d& v) {
  return (std::abs(v.x()) + std::abs(v.y())) + std::abs(v.z());
}

}  // namespace

StandIn moving_stand_in(const MovingShape& field, const MovingShape& other,
                        const RigidContactSettings& settings, double aside) {
  const RigidMotion& motion = field.motion;
  const PlacedShapeView placed{field.shape, motion.start()};
  const auto* as_field = field.shape.as<HeightField>();
  if (as_field == nullptr) return StandIn(placed, placed, {});
  const HeightFieldData& data = HeightFieldAccess::data(*as_field);
  if (other.is_half_space()) {
    FieldQuery all(data, motion.start(), PlacedShapeView{other.shape, other.motion.start()});
    all.grow(0x1p10 * kLargestLength);
    return StandIn(placed, all, {});
  }
  FieldQuery query(data, motion.start(), swept_bounds(other));
  double room = settings.clearance + settings.tolerance +
                kMotionRoom * (field.lengths + other.lengths + settings.clearance) +
                kTurnRoom * (field.turned * field.radius + other.turned * other.radius);
  if (field.turned > 0) {
    room += std::min(field.turned, 2.0) * field.radius + length_of(motion.shift());
  } else {
    query.move(motion.start(), -motion.shift());
  }
  query.grow(room);
  return StandIn(placed, query,
                 {.aside = aside * (2 * other.radius + settings.clearance),
                  .is_kept = keeps_patches({other.shape, other.motion.start()})});
}

StandIn cast_stand_in(const PlacedShapeView& field, const PlacedShapeView& other,
                      const Eigen::Vector3d& displacement) {
  const auto* as_field = field.shape.as<HeightField>();
  if (as_field == nullptr) return StandIn(field, other, {});
  const HeightFieldData& data = HeightFieldAccess::data(*as_field);
  FieldQuery query(data, field.pose, other);
  query.move(field.pose, displacement);
  const Aabb own = bounding_aabb(field), box = bounding_aabb(other);
  query.grow(kMotionRoom * (sum_of(own.min) + sum_of(own.max) + sum_of(box.min) + sum_of(box.max) +
                            sum_of(displacement)));
  return StandIn(field, query, {.is_kept = keeps_patches(other)});
}

}  // namespace graze

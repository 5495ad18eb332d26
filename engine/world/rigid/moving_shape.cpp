#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/world/rigid/moving_shape.h>
#include <graze/engine/world/shape_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace graze {

namespace {

/// Returns the radius of the ball that makes the shape when it is moved along a point or a segment.
double rounded_by(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape.value())) return sphere->radius;
  if (const auto* capsule = std::get_if<Capsule>(&shape.value())) return capsule->radius;
  return 0;
}

/// Returns how far the plane of a half-space, or a plane, is from the origin of its frame.
double offset_of(const Shape& shape) {
  const auto* half_space = std::get_if<HalfSpace>(&shape.value());
  return std::abs(half_space != nullptr ? half_space->offset
                                        : std::get<Plane>(shape.value()).offset);
}

}  // namespace

double length_of(const Eigen::Vector3d& v) {
  return std::sqrt((v.x() * v.x() + v.y() * v.y()) + v.z() * v.z());
}

MovingShape::MovingShape(const Shape& of_shape, const RigidMotion& in_motion, const char* what)
    : shape(of_shape),
      motion(in_motion),
      turned(std::abs(in_motion.angle())),
      lengths(sum_of_lengths(in_motion)) {
  if (is_endless()) {
    check_coordinates(motion, {{0, 0, 0}, {0, 0, 0}}, what);
    lengths += offset_of(shape);
    return;
  }
  const Pose& start = motion.start();
  const Aabb bounds = bounding_aabb({shape, start});
  check_coordinates(motion, bounds, what);
  const Eigen::Vector3d middle = bounds.min / 2 + bounds.max / 2;
  const double apart = length_of(middle - motion.centre());
  const Eigen::Vector3d half = bounds.max / 2 - bounds.min / 2;
  const Eigen::Vector3d rounded = Eigen::Vector3d::Constant(rounded_by(shape));
  radius = (apart + length_of(half)) * kStretch;
  // The rounding of boxes is a share of `lengths`, for which the users of this radius leave room.
  turning_radius = (apart + length_of((half - rounded).cwiseMax(0))) * kStretch;
  lengths += radius;
}

Aabb swept_bounds(const MovingShape& moving) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  const Eigen::Vector3d all = Eigen::Vector3d::Constant(kLargest);
  if (moving.is_endless()) return {-all, all};
  const RigidMotion& motion = moving.motion;
  Aabb first, last;
  if (moving.turned == 0) {
    first = bounding_aabb({moving.shape, motion.start()});
    last = {first.min + motion.shift(), first.max + motion.shift()};
  } else {
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(moving.radius);
    first = {motion.centre() - half, motion.centre() + half};
    last = {first.min + motion.shift(), first.max + motion.shift()};
  }
  // This covers the rounding of poses, as in Approach, and of these sums.
  const Eigen::Vector3d rounding =
      Eigen::Vector3d::Constant(0x1p-40 * moving.lengths + 0x1p-50 * moving.turned * moving.radius);
  return {first.min.cwiseMin(last.min) - rounding, first.max.cwiseMax(last.max) + rounding};
}

}  // namespace graze

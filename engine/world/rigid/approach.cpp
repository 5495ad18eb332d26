#include <graze/engine/world/rigid/approach.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

// The least tolerance, as a share of all lengths: distances of shapes are known to 2^-34 of their
// scale.
constexpr double kLeastTolerance = 0x1p-28;

/// Returns the most by which turning moves a point of the shape, metres, in places where the other
/// shape can be.
double turning_travel_of(const MovingShape& moving, const MovingShape& other) {
  if (!moving.is_half_space() || moving.turned == 0) return moving.turned * moving.turning_radius;
  const double apart = length_of(moving.motion.centre() - other.motion.centre());
  const double shifts = length_of(moving.motion.shift()) + length_of(other.motion.shift());
  return moving.turned * ((apart + shifts) + other.radius) * MovingShape::kStretch;
}

}  // namespace

Approach::Approach(const MovingShape& a, const MovingShape& b, const RigidContactSettings& settings)
    : shift(b.motion.shift() - a.motion.shift()),
      turning_travel(turning_travel_of(a, b) + turning_travel_of(b, a)),
      travel(length_of(shift) * MovingShape::kStretch + turning_travel) {
  const double lengths = a.lengths + b.lengths;
  const double tolerance =
      std::max({settings.tolerance, kLeastTolerance * lengths, 0x1p-44 * travel});
  limit = settings.clearance + tolerance;
  // Poses are rounded: a shape that makes many turns is off by 2^-51 of its travel.
  rounding = 0x1p-40 * lengths + 0x1p-50 * travel;
  grid = TimeGrid::for_steps(travel, tolerance / 4);
}

Approach Approach::mirrored() const {
  Approach swapped = *this;
  swapped.shift = -shift;
  return swapped;
}

// Each product rounds by less than 2^-50 of the sizes of its factors.
Closing turning_closing(const RigidMotion& motion, double time, const narrowphase::Core& core,
                        const Eigen::Vector3d& origin, const Eigen::Vector3d& along,
                        double radius) {
  const double angle = motion.angle();
  if (angle == 0) return {0, 0};
  const narrowphase::Vec3 w = cross(to_vec3(along), to_vec3(motion.axis())) * angle;
  const Eigen::Vector3d centre = motion.centre() + time * motion.shift();
  const narrowphase::Vec3 arm = narrowphase::support(core, w) + (to_vec3(origin) - to_vec3(centre));
  const double size = std::abs(angle) * (length_of(origin - centre) + radius);
  return {dot(w, arm) + 0x1p-46 * size, angle * angle * radius};
}

// A unit vector is off by less than 2^-50.
Closing Approach::closing(const Eigen::Vector3d& normal, const Closing& turning) const {
  const double along = normal.x() * shift.x() + normal.y() * shift.y() + normal.z() * shift.z();
  return {(turning.rate - along) + 0x1p-48 * length_of(shift), turning.bend};
}

// The larger root of rate d + bend d^2 / 2 = gap, in the form that does not cancel.
std::uint64_t Approach::steps(double gap, const Closing& closing, std::uint64_t most) const {
  const double left = gap - limit - rounding;
  if (!(left > 0)) return 1;
  const double rate = closing.rate + (MovingShape::kStretch - 1) * std::abs(closing.rate);
  const double bend = closing.bend * MovingShape::kStretch;
  const double root = std::sqrt(rate * rate + 2 * bend * left);
  const double time = rate > 0 ? 2 * left / (rate + root) : (root - rate) / bend;
  const double count = time * (2 - MovingShape::kStretch) / grid.step();
  if (!(count < static_cast<double>(most))) return most;
  return std::max(std::uint64_t{1}, static_cast<std::uint64_t>(count));
}

}  // namespace graze

#include <graze/engine/world/rigid/approach.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

// Of all lengths: distances of shapes are known to 2^-34 of their scale.
constexpr double kLeastTolerance = 0x1p-28;

/// How far turning moves a point of the shape, metres, at most, where the other one can be.
double turning_way_of(const MovingShape& moving, const MovingShape& other) {
  if (!moving.is_half_space() || moving.turned == 0) return moving.turned * moving.turning_reach;
  const double apart = length_of(moving.motion.centre() - other.motion.centre());
  const double shifts = length_of(moving.motion.shift()) + length_of(other.motion.shift());
  return moving.turned * ((apart + shifts) + other.reach) * MovingShape::kStretch;
}

}  // namespace

Approach::Approach(const MovingShape& a, const MovingShape& b, const RigidContactSettings& settings)
    : shift(b.motion.shift() - a.motion.shift()),
      turning_way(turning_way_of(a, b) + turning_way_of(b, a)),
      way(length_of(shift) * MovingShape::kStretch + turning_way) {
  const double lengths = a.lengths + b.lengths;
  const double tolerance = std::max({settings.tolerance, kLeastTolerance * lengths, 0x1p-44 * way});
  limit = settings.clearance + tolerance;
  // Poses are rounded: what turns by many times is off by 2^-51 of its way.
  rounding = 0x1p-40 * lengths + 0x1p-50 * way;
  grid = TimeGrid::for_steps(way, tolerance / 4);
}

Approach Approach::mirrored() const {
  Approach swapped = *this;
  swapped.shift = -shift;
  return swapped;
}

// A unit vector is off by less than 2^-50.
double Approach::closing_way(const Eigen::Vector3d& normal) const {
  const double along = normal.x() * shift.x() + normal.y() * shift.y() + normal.z() * shift.z();
  return (std::max(-along, 0.0) + 0x1p-48 * length_of(shift)) + turning_way;
}

std::uint64_t Approach::steps(double gap, double closing, std::uint64_t most) const {
  const double count = (gap - limit - rounding) / (closing * MovingShape::kStretch) / grid.step();
  if (!(count < static_cast<double>(most))) return most;
  return std::max(std::uint64_t{1}, static_cast<std::uint64_t>(std::max(count, 0.0)));
}

}  // namespace graze

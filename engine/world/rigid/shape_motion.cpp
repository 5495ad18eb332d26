#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/nearest/distance_parts.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/rigid/first_hit.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/mesh/rigid/time_grid.h>
#include <graze/engine/world/rigid/moving_shape.h>
#include <graze/engine/world/shape_motion.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

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

/// Two shapes, and the times at which they are asked about.
class ShapeMotion {
 public:
  ShapeMotion(const MovingShape& a, const MovingShape& b, const RigidContactSettings& settings,
              Work& work)
      : a_(a), b_(b), clearance_(settings.clearance), budget_(settings.budget), work_(work) {
    shift_ = b.motion.shift() - a.motion.shift();
    turning_way_ = turning_way_of(a, b) + turning_way_of(b, a);
    way_ = length_of(shift_) * MovingShape::kStretch + turning_way_;
    const double least = kLeastTolerance * (a.lengths + b.lengths);
    const double tolerance = std::max({settings.tolerance, least, 0x1p-44 * way_});
    limit_ = clearance_ + tolerance;
    // Poses are rounded: what turns by many times is off by 2^-51 of its way.
    rounding_ = 0x1p-40 * (a.lengths + b.lengths) + 0x1p-50 * way_;
    grid_ = TimeGrid::for_steps(way_, tolerance / 4);
  }

  const TimeGrid& grid() const { return grid_; }
  bool is_out_of_budget() const { return is_out_of_budget_; }

  /// The first time at which they may be as near as the limit, or where the budget ends; the end of
  /// the grid if there is none.
  std::uint64_t find_low() {
    std::uint64_t k = 0;
    while (k < grid_.end()) {
      is_out_of_budget_ = budget_ == 0;
      if (is_out_of_budget_) return k;
      --budget_;
      const PlacedShape a = a_.at(grid_.time(k)), b = b_.at(grid_.time(k));
      const ShapeDistance found = distance(a, b, &work_);
      const double bound = found.lower_bound;
      if (!(bound > limit_)) return k;
      // In one step they stay further apart than the clearance; in more while the bound lasts.
      const double steps = (bound - limit_ - rounding_) / closing_way(found.normal) / grid_.step();
      if (!(steps < static_cast<double>(grid_.end() - k))) return grid_.end();
      k += std::max(std::uint64_t{1}, static_cast<std::uint64_t>(std::max(steps, 0.0)));
    }
    return grid_.end();
  }

  /// How far the two come nearer to each other in all, metres, at most. Of convex shapes the gap
  /// between two planes at right angles to the normal is the bound (distance()), and what moves
  /// along these planes does not close it: Mirtich's bound (Impulse-based Dynamic Simulation of
  /// Rigid Body Systems, 1996, section 2.3). A unit vector is off by less than 2^-50.
  double closing_way(const Eigen::Vector3d& normal) const {
    if (!are_convex_) return way_ * MovingShape::kStretch;
    const double along =
        normal.x() * shift_.x() + normal.y() * shift_.y() + normal.z() * shift_.z();
    const double shift = std::max(-along, 0.0) + 0x1p-48 * length_of(shift_);
    return (shift + turning_way_) * MovingShape::kStretch;
  }

  bool is_hit(std::uint64_t k) {
    const PlacedShape a = a_.at(grid_.time(k)), b = b_.at(grid_.time(k));
    if (clearance_ == 0) return intersects(a, b, &work_);
    return distance(a, b, &work_).distance <= clearance_;
  }

 private:
  const MovingShape& a_;
  const MovingShape& b_;
  double clearance_;
  std::uint64_t budget_;
  Work& work_;
  bool are_convex_ = a_.shape.kind() != ShapeKind::Mesh && b_.shape.kind() != ShapeKind::Mesh;
  Eigen::Vector3d shift_;  ///< of B, less that of A
  double turning_way_;
  double way_;
  double limit_;
  double rounding_;
  TimeGrid grid_{0};
  bool is_out_of_budget_ = false;
};

const Mesh* mesh_of(const Shape& shape) {
  return std::get_if<Mesh>(&shape.value());
}

RigidContact contact_of_shapes(const MovingShape& a, const MovingShape& b,
                               const RigidContactSettings& settings, Work& work) {
  if (a.is_half_space() && b.is_half_space() && a.turned + b.turned > 0)
    throw UnsupportedPairError("two half-spaces of which one turns: they meet far away");
  ShapeMotion motion(a, b, settings, work);
  const TimeGrid& grid = motion.grid();
  const std::uint64_t low = motion.find_low();
  if (low == grid.end()) return {RigidStatus::Free, 1, 1, false};
  if (motion.is_out_of_budget()) return {RigidStatus::Close, grid.time(low), 1, true};
  const auto high = first_hit(low, grid.end(), [&](std::uint64_t k) { return motion.is_hit(k); });
  if (!high) return {RigidStatus::Close, grid.time(low), 1, false};
  return {RigidStatus::Hit, grid.time(low), grid.time(*high), false};
}

}  // namespace

RigidContact first_contact(const Shape& shape_a, const RigidMotion& motion_a, const Shape& shape_b,
                           const RigidMotion& motion_b, const RigidContactSettings& settings,
                           Work* work) {
  const Mesh *mesh_a = mesh_of(shape_a), *mesh_b = mesh_of(shape_b);
  if (mesh_a != nullptr && mesh_b != nullptr)
    return first_contact(*mesh_a, motion_a, *mesh_b, motion_b, settings, work);
  return bvh::in_standard_arithmetic([&]() -> RigidContact {
    CountedWork counted(work);
    check_settings(settings);
    return contact_of_shapes({shape_a, motion_a, "motion of shape A"},
                             {shape_b, motion_b, "motion of shape B"}, settings, counted.work());
  });
}

bool is_free(const Shape& shape_a, const RigidMotion& motion_a, const Shape& shape_b,
             const RigidMotion& motion_b, const RigidContactSettings& settings, Work* work) {
  return first_contact(shape_a, motion_a, shape_b, motion_b, settings, work).status ==
         RigidStatus::Free;
}

}  // namespace graze

#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/nearest/distance_parts.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/rigid/first_hit.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/mesh/rigid/time_grid.h>
#include <graze/engine/world/rigid/mesh_approach.h>
#include <graze/engine/world/rigid/moving_stand_in.h>
#include <graze/engine/world/shape_motion.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/half_space_pair.h>
#include <graze/engine/world/shapes/pair_input.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <variant>

namespace graze {
namespace {

/// Two shapes, and the times at which they are asked about.
class ShapeMotion {
 public:
  ShapeMotion(const MovingShape& a, const MovingShape& b, const RigidContactSettings& settings,
              Work& work)
      : a_(a),
        b_(b),
        approach_(a, b, settings),
        clearance_(settings.clearance),
        budget_(settings.budget),
        work_(work) {}

  const TimeGrid& grid() const { return approach_.grid; }
  bool is_out_of_budget() const { return is_out_of_budget_; }

  /// Returns the first time at which they may be as near as the limit, or where the budget ends, as
  /// a step of the grid; the end of the grid if there is none.
  std::uint64_t find_low() {
    if (MeshApproach::is_for(a_, b_)) return find_low_of_mesh(a_, b_, approach_);
    if (MeshApproach::is_for(b_, a_)) return find_low_of_mesh(b_, a_, approach_.mirrored());
    const std::uint64_t end = grid().end();
    for (std::uint64_t k = 0; k < end;) {
      is_out_of_budget_ = budget_ == 0;
      if (is_out_of_budget_) return k;
      --budget_;
      const double t = grid().time(k);
      const Pose pose_a = a_.motion.at(t), pose_b = b_.motion.at(t);
      const ShapeDistance found =
          distance_of_checked({a_.shape, pose_a}, {b_.shape, pose_b}, work_);
      const double gap = found.lower_bound;
      if (!(gap > approach_.limit)) return k;
      // In one step they stay further apart than the clearance, and in more steps while the gap
      // lasts.
      k += approach_.steps(gap, closing(t, pose_a, pose_b, found.normal), end - k);
    }
    return end;
  }

  bool is_hit(std::uint64_t k) {
    const Pose pose_a = a_.motion.at(grid().time(k)), pose_b = b_.motion.at(grid().time(k));
    const PlacedShapeView a{a_.shape, pose_a}, b{b_.shape, pose_b};
    if (clearance_ == 0) return intersect_checked(a, b, work_);
    return distance_of_checked(a, b, work_).distance <= clearance_;
  }

 private:
  std::uint64_t find_low_of_mesh(const MovingShape& convex, const MovingShape& mesh,
                                 const Approach& approach) {
    // Testing whether they meet costs less than measuring how far apart they are.
    if (clearance_ == 0 && budget_ > 0 && is_hit(0)) return 0;
    MeshApproach to_mesh(convex, mesh, approach, work_);
    const std::uint64_t low = to_mesh.find_low(budget_);
    is_out_of_budget_ = to_mesh.is_out_of_budget();
    return low;
  }

  /// Returns how the gap closes from a time on. For a mesh beside a plane its convex hull counts. A
  /// half-space that turns moves the faster the further out.
  Closing closing(double t, const Pose& pose_a, const Pose& pose_b,
                  const Eigen::Vector3d& normal) const {
    if ((a_.is_half_space() && a_.turned > 0) || (b_.is_half_space() && b_.turned > 0))
      return approach_.closing();
    const Closing of_a = turning(a_, t, pose_a, normal), of_b = turning(b_, t, pose_b, -normal);
    return approach_.closing(normal, {of_a.rate + of_b.rate, of_a.bend + of_b.bend});
  }

  static Closing turning(const MovingShape& moving, double t, const Pose& pose,
                         const Eigen::Vector3d& along) {
    if (moving.turned == 0) return {0, 0};
    if (moving.is_mesh()) return {moving.turned * moving.turning_radius, 0};
    const Eigen::Vector3d origin = middle_of(moving.shape, pose);
    return turning_closing(moving.motion, t, core_of(moving.shape, pose, origin), origin, along,
                           moving.turning_radius);
  }

  const MovingShape& a_;
  const MovingShape& b_;
  Approach approach_;
  double clearance_;
  std::uint64_t budget_;
  Work& work_;
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

/// Answers a pair with one height field, or two.
RigidContact contact_of_field(const MovingShape& a, const MovingShape& b,
                              const RigidContactSettings& settings, Work& work) {
  const StandIn by_a = moving_stand_in(a, b, settings, 0);
  const StandIn by_b = moving_stand_in(b, a, settings, 0);
  return first_contact_of_shapes(by_a.shape(), a.motion, by_b.shape(), b.motion, settings, &work);
}

/// Returns the earlier of the contacts with two parts, either of which may be met first.
RigidContact earlier(const RigidContact& s, const RigidContact& t) {
  if (s.status == RigidStatus::Free) return t;
  if (t.status == RigidStatus::Free) return s;
  const bool is_hit = s.status == RigidStatus::Hit || t.status == RigidStatus::Hit;
  return {is_hit ? RigidStatus::Hit : RigidStatus::Close, std::min(s.low, t.low),
          std::min(s.high, t.high), s.is_out_of_budget || t.is_out_of_budget};
}

/// Returns whether two shapes are no further apart than the clearance at a time.
bool are_near(const Shape& shape_a, const Shape& shape_b, const MovingShape& a,
              const MovingShape& b, double time, double clearance, Work& work) {
  const Pose pose_a = a.motion.at(time), pose_b = b.motion.at(time);
  const PlacedShapeView placed_a{shape_a, pose_a}, placed_b{shape_b, pose_b};
  if (clearance == 0) return intersects(placed_a, placed_b, &work);
  return distance(placed_a, placed_b, &work).distance <= clearance;
}

/// Answers a pair with one plane, or two. A shape that has come through a plane still touches the
/// half-space that stands for it. So the time of the hit is brought down to a double just before
/// which the half-space is not touched, and it is a hit if the plane itself is touched then.
RigidContact contact_of_plane(const MovingShape& a, const MovingShape& b,
                              const RigidContactSettings& settings, Work& work) {
  const HalfSpacePair by({a.shape, a.motion.start()}, {b.shape, b.motion.start()}, work);
  const auto ask = [&](std::size_t i) {
    return first_contact_of_shapes(by.a(i).shape, a.motion, by.b(i).shape, b.motion, settings,
                                   &work);
  };
  RigidContact found = by.is_divided() ? earlier(ask(0), ask(1)) : ask(0);
  const auto is_near = [&](const Shape& shape_a, const Shape& shape_b, double time) {
    return are_near(shape_a, shape_b, a, b, time, settings.clearance, work);
  };
  if (found.status != RigidStatus::Hit || is_near(a.shape, b.shape, found.high)) return found;
  const auto is_passed = [&](double time) {
    return is_near(by.a(0).shape, by.b(0).shape, time) ||
           (by.is_divided() && is_near(by.a(1).shape, by.b(1).shape, time));
  };
  double before = found.low;
  for (double middle = std::midpoint(before, found.high); before < middle && middle < found.high;
       middle = std::midpoint(before, found.high))
    (is_passed(middle) ? found.high : before) = middle;
  if (!is_near(a.shape, b.shape, found.high))
    return {RigidStatus::Close, found.low, 1, found.is_out_of_budget};
  return found;
}

}  // namespace

RigidContact contact_of_moving(const MovingShape& a, const MovingShape& b,
                               const RigidContactSettings& settings, Work& work) {
  const PlacedShapeView start_a{a.shape, a.motion.start()}, start_b{b.shape, b.motion.start()};
  if (has_field(start_a, start_b)) return contact_of_field(a, b, settings, work);
  if (has_plane(start_a, start_b)) return contact_of_plane(a, b, settings, work);
  const Mesh *mesh_a = mesh_of(a.shape), *mesh_b = mesh_of(b.shape);
  if (mesh_a != nullptr && mesh_b != nullptr)
    return first_contact({*mesh_a, a.motion}, {*mesh_b, b.motion}, settings, &work);
  return contact_of_shapes(a, b, settings, work);
}

RigidContact first_contact_of_shapes(const Shape& shape_a, const RigidMotion& motion_a,
                                     const Shape& shape_b, const RigidMotion& motion_b,
                                     const RigidContactSettings& settings, Work* work) {
  const Mesh *mesh_a = mesh_of(shape_a), *mesh_b = mesh_of(shape_b);
  if (mesh_a != nullptr && mesh_b != nullptr)
    return first_contact({*mesh_a, motion_a}, {*mesh_b, motion_b}, settings, work);
  CountedWork counted(work);
  check_settings(settings);
  return contact_of_moving({shape_a, motion_a, "motion of shape A"},
                           {shape_b, motion_b, "motion of shape B"}, settings, counted.work());
}

template <typename>
RigidContact first_contact(const ShapeInMotion& shape_a, const ShapeInMotion& shape_b,
                           const RigidContactSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> RigidContact {
    return first_contact_of_shapes(shape_a.shape, shape_a.motion, shape_b.shape, shape_b.motion,
                                   settings, work);
  });
}

template <typename>
bool is_free(const ShapeInMotion& shape_a, const ShapeInMotion& shape_b,
             const RigidContactSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    return first_contact(shape_a, shape_b, settings, work).status == RigidStatus::Free;
  });
}

template RigidContact first_contact<void>(const ShapeInMotion&, const ShapeInMotion&,
                                          const RigidContactSettings&, Work*);
template bool is_free<void>(const ShapeInMotion&, const ShapeInMotion&, const RigidContactSettings&,
                            Work*);

}  // namespace graze

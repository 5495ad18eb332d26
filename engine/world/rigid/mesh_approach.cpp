#include <graze/bvh/traverse/traverse_nearest.h>
#include <graze/engine/world/rigid/mesh_approach.h>
#include <graze/engine/world/rigid/tree_sweep.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/triangle.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace graze {

using narrowphase::Core;
using narrowphase::Vec3;

namespace {

/// The bound of a node that the box is never near, or only after a triangle that was found.
constexpr double kNever = 2;

RigidMotion relative_motion(const RigidMotion& of, const RigidMotion& to) {
  return {of.start(),
          {.centre = of.centre(),
           .shift = of.shift() - to.shift(),
           .axis = of.axis(),
           .angle = of.angle()}};
}

/// Returns a set that holds the shape at 0 in all directions in which it turns.
Core core_in_all_directions(const MovingShape& moving, const Eigen::Vector3d& origin) {
  if (moving.turned == 0) return core_of(moving.shape, moving.motion.start(), origin);
  Core ball;
  ball.at = to_vec3(moving.motion.centre()) - to_vec3(origin);
  ball.radius = moving.radius;
  return ball;
}

}  // namespace

/// The bounds of nodes for traverse_nearest(): the bound of a node is the first time at which the
/// box is near it.
struct MeshApproach::TimesOfNodes {
  MeshApproach& approach;
  const TreeSweep& sweep;

  double of(std::uint32_t node) const {
    ++approach.work_.volume_tests;
    const NearTimes times = sweep.of_node(node);
    const bool is_never = !(times.first <= times.last);
    approach.work_.volume_rejections += is_never;
    return is_never ? kNever : times.first;
  }
  bool is_missed(double bound) const { return bound == kNever; }
  bool is_beyond(double bound) const { return approach.step_before(bound) >= approach.low_; }
};

bool MeshApproach::is_for(const MovingShape& convex, const MovingShape& mesh) {
  return is_convex_core(convex.shape.kind()) && mesh.is_mesh();
}

MeshApproach::MeshApproach(const MovingShape& convex, const MovingShape& mesh,
                           const Approach& approach, Work& work)
    : convex_(convex),
      mesh_(mesh),
      triangles_(std::get<Mesh>(mesh.shape.value())),
      approach_(approach),
      work_(work),
      relative_(relative_motion(convex.motion, mesh.motion)) {}

// Powers of two divide exactly, and the rounding of a time is within the room of the sweep.
std::uint64_t MeshApproach::step_before(double t) const {
  return static_cast<std::uint64_t>(t / approach_.grid.step());
}

std::uint64_t MeshApproach::find_low(std::uint64_t budget, const std::optional<SlidingRule>& rule) {
  low_ = approach_.grid.end();
  budget_ = budget;
  rule_ = rule;
  is_out_of_budget_ = false;
  const PlacedMeshView placed{triangles_, mesh_.motion.start()};
  const Eigen::Vector3d origin = middle_of(convex_.shape, relative_.start());
  const Core core = core_in_all_directions(convex_, origin);
  const MeshDescent descent(placed, core, origin, work_);
  const double turning = mesh_.turned * mesh_.radius * MovingShape::kStretch;
  const TreeSweep sweep(descent, placed, relative_.shift(),
                        (approach_.limit + approach_.rounding) + turning);
  bvh::traverse_nearest(descent.tree(), TimesOfNodes{*this, sweep}, [&](const bvh::Node& leaf) {
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count && !is_out_of_budget_; ++i) {
      const std::uint32_t triangle = descent.tree().primitives[i];
      const NearTimes times = sweep.of_triangle(triangle);
      if (!(times.first <= times.last) || step_before(times.first) >= low_) continue;
      if (!rule_ || !slides_along(triangle)) approach_triangle(triangle, times);
    }
    return is_out_of_budget_ ? bvh::Walk::Stop : bvh::Walk::Continue;
  });
  if (is_out_of_budget_) low_ = step_before(sweep.of_node(0).first);
  return low_;
}

/// Looks for a time before low_, while the box is near the triangle.
void MeshApproach::approach_triangle(std::uint32_t triangle, const NearTimes& times) {
  const std::uint64_t end = std::min(low_, step_before(times.last) + 2);
  for (std::uint64_t k = step_before(times.first); k < end;) {
    is_out_of_budget_ = budget_ == 0;
    if (is_out_of_budget_) return;
    --budget_;
    const Gap gap = gap_at(k, triangle);
    if (!(gap.lower > approach_.limit)) {
      if (k == 0 && rule_) return;
      low_ = k, found_ = triangle;
      return;
    }
    k += approach_.steps(gap.lower, gap.closing, end - k);
  }
}

MeshApproach::Gap MeshApproach::gap_at(std::uint64_t k, std::uint32_t triangle) const {
  ++work_.triangle_tests, ++work_.convex_tests;
  const double t = approach_.grid.time(k);
  const Pose pose = convex_.motion.at(t);
  const Eigen::Vector3d origin = middle_of(convex_.shape, pose);
  const Triangle placed = narrowphase::place(mesh_.motion.at(t), triangles_.triangle(triangle));
  const Core core = core_of(convex_.shape, pose, origin), met = core_of(placed, origin);
  const SetGap gap = gap_of_sets(core, met);
  work_.convex_failures += gap.status == PairStatus::NotConverged;
  const Eigen::Vector3d normal = to_eigen(gap.normal);
  Closing turning =
      turning_closing(convex_.motion, t, core, origin, normal, convex_.turning_radius);
  if (mesh_.turned != 0) {
    const Eigen::Vector3d centre = mesh_.motion.centre() + t * mesh_.motion.shift();
    const double radius = std::max({length_of(placed.a - centre), length_of(placed.b - centre),
                                    length_of(placed.c - centre)}) *
                          MovingShape::kStretch;
    const Closing of_mesh = turning_closing(mesh_.motion, t, met, origin, -normal, radius);
    turning.rate += of_mesh.rate, turning.bend += of_mesh.bend;
  }
  return {gap.lower, approach_.closing(normal, turning)};
}

/// Returns how far the shape is behind the plane through a corner at right angles to a unit vector,
/// which points to where the shape comes from.
double MeshApproach::depth_behind(const Triangle& triangle, double t,
                                  const Eigen::Vector3d& normal) const {
  const Core core = core_of(convex_.shape, relative_.at(t), triangle.a);
  const Vec3 behind = -to_vec3(normal);
  return dot(narrowphase::rounded_support(core, behind), behind);
}

// Between 0 and 1 a point is beside the chord of its path by at most the sagitta. For a turn by an
// angle that is r (1 - cos(angle/2)), at most r angle^2 / 8, and at most 2 r for any angle.
bool MeshApproach::slides_along(std::uint32_t triangle) const {
  const Triangle placed = narrowphase::place(mesh_.motion.start(), triangles_.triangle(triangle));
  const Eigen::Vector3d edge_b = placed.b - placed.a, edge_c = placed.c - placed.a;
  const Eigen::Vector3d across(edge_b.y() * edge_c.z() - edge_b.z() * edge_c.y(),
                               edge_b.z() * edge_c.x() - edge_b.x() * edge_c.z(),
                               edge_b.x() * edge_c.y() - edge_b.y() * edge_c.x());
  const double area = length_of(across);
  const Eigen::Vector3d from = middle_of(convex_.shape, relative_.start()) - placed.a;
  const double side = from.x() * across.x() + from.y() * across.y() + from.z() * across.z();
  if (!(area > 0) || side == 0) return false;
  const Eigen::Vector3d normal = across / (side > 0 ? area : -area);
  const double sagitta =
      convex_.turning_radius * std::min(convex_.turned * convex_.turned / 8, 2.0);
  const double depth =
      std::max(depth_behind(placed, 0, normal), depth_behind(placed, 1, normal)) + sagitta;
  return depth <= rule_->depth;
}

}  // namespace graze

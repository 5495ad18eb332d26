#include <graze/engine/mesh/rigid/first_hit.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/rigid/mesh_approach.h>
#include <graze/engine/world/rigid/moving_stand_in.h>
#include <graze/engine/world/rigid/sliding_contact.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <algorithm>
#include <variant>
#include <vector>

namespace graze {
namespace {

/// Returns the triangle as a mesh of its own.
Mesh alone(const Mesh& mesh, std::uint32_t index) {
  const Triangle triangle = mesh.triangle(index);
  return Mesh(std::vector{triangle.a, triangle.b, triangle.c},
              std::vector<TriangleIndices>{{0, 1, 2}});
}

std::optional<SlidingContact> after_sliding(const MovingShape& convex, const MovingShape& mesh,
                                            const RigidContactSettings& settings, double depth,
                                            Work& work) {
  double deepest = 0;
  for (const ShapeContact& contact : find_contacts(convex.at(0), mesh.at(0), {}, &work))
    deepest = std::max(deepest, contact.depth);
  const Approach approach(convex, mesh, settings);
  const TimeGrid& grid = approach.grid;
  MeshApproach to_mesh(convex, mesh, approach, work);
  const std::uint64_t low = to_mesh.find_low(settings.budget, SlidingRule{deepest + depth});
  if (low == grid.end()) return std::nullopt;
  if (to_mesh.is_out_of_budget()) {
    return SlidingContact{{RigidStatus::Close, grid.time(low), 1, true},
                          Eigen::Vector3d::Zero(),
                          Eigen::Vector3d::Zero()};
  }
  const Shape met = alone(std::get<Mesh>(mesh.shape.value()), to_mesh.found());
  const auto high = first_hit(low, grid.end(), [&](std::uint64_t k) {
    const double t = grid.time(k);
    const PlacedShape placed{met, mesh.motion.at(t)};
    if (settings.clearance == 0) return intersects(convex.at(t), placed, &work);
    return distance(convex.at(t), placed, &work).distance <= settings.clearance;
  });
  const double t = grid.time(low);
  const ShapeDistance nearest = distance(convex.at(t), {met, mesh.motion.at(t)}, &work);
  return SlidingContact{
      {high ? RigidStatus::Hit : RigidStatus::Close, t, high ? grid.time(*high) : 1, false},
      nearest.normal,
      nearest.point_a / 2 + nearest.point_b / 2};
}

}  // namespace

std::optional<SlidingContact> contact_after_sliding(
    const Shape& shape_a, const RigidMotion& motion_a, const Shape& shape_b,
    const RigidMotion& motion_b, const RigidContactSettings& settings, double depth, Work& work) {
  const MovingShape a(shape_a, motion_a, "motion of shape A");
  const MovingShape b(shape_b, motion_b, "motion of shape B");
  if (has_field({shape_a, motion_a.start()}, {shape_b, motion_b.start()})) {
    const StandIn by_a = moving_stand_in(a, b, settings, kContactAside);
    const StandIn by_b = moving_stand_in(b, a, settings, kContactAside);
    return contact_after_sliding(by_a.shape(), motion_a, by_b.shape(), motion_b, settings, depth,
                                 work);
  }
  const auto is_for = [](const MovingShape& convex, const MovingShape& mesh) {
    return MeshApproach::is_for(convex, mesh) && mesh.turned == 0;
  };
  if (is_for(a, b)) return after_sliding(a, b, settings, depth, work);
  if (!is_for(b, a)) return std::nullopt;
  std::optional<SlidingContact> found = after_sliding(b, a, settings, depth, work);
  if (found) found->normal = -found->normal;
  return found;
}

}  // namespace graze

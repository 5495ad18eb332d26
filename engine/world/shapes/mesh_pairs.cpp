#include <graze/engine/mesh/volume_query.h>
#include <graze/engine/world/shapes/mesh_descent.h>
#include <graze/engine/world/shapes/pair_functions.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace graze {

using narrowphase::Core;
using narrowphase::Vec3;

bool intersect_mesh_core(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  const PlacedMeshView mesh{*b.shape.as<Mesh>(), b.pose};
  const Eigen::Vector3d origin = middle_of(a.shape, a.pose);
  const Core core = core_of(a.shape, a.pose, origin);
  MeshDescent descent(mesh, core, origin, work);
  bool is_hit = false;
  descent.for_each_near([&](std::uint32_t index) {
    PairStatus status{};
    is_hit = !are_apart(core, descent.triangle(index), status);
    ++work.convex_tests;
    work.convex_failures += status == PairStatus::NotConverged;
    return is_hit ? bvh::Walk::Stop : bvh::Walk::Continue;
  });
  return is_hit;
}

namespace {

constexpr double kDoubt = 0x1p-20;

/// Measures two that are apart though a search leaves that open: the points are one of each, and
/// the distance is theirs.
void measure_apart(const Core& core, const Core& triangle, SetGap& gap) {
  const narrowphase::CoreGap found = narrowphase::nearest(core, triangle);
  const Vec3 between = unit_or(found.point_b - found.point_a, found.normal);
  gap.point_a = found.point_a + between * core.radius;
  gap.point_b = found.point_b;
  gap.distance = std::max(gap.distance, found.upper - core.radius);
}

/// Keeps a triangle apart whose box is apart from the set's. intersect_mesh_core() does not look at
/// such a triangle, so that two which only the gap's tolerance brings together are apart for the
/// distance, too, by the gap that the boxes prove.
void keep_apart(SetGap& gap, const Core& core, const MeshDescent& descent, std::uint32_t index) {
  if (!descent.is_triangle_apart(index)) return;
  gap.lower = descent.triangle_bound(index);
  gap.distance = std::max(gap.lower, std::numeric_limits<double>::denorm_min());
  if (gap.status == PairStatus::NotConverged) measure_apart(core, descent.triangle(index), gap);
}

/// Returns the sphere in the world's frame, or nothing for other shapes.
std::optional<Sphere> placed_ball(const PlacedShapeView& a, const Eigen::Vector3d& middle) {
  const auto* sphere = a.shape.as<Sphere>();
  return sphere == nullptr ? std::nullopt : std::optional(Sphere{middle, sphere->radius});
}

/// True if the search leaves a ball's gap open, or if rounding is more than a millionth of the gap.
bool is_in_doubt(const SetGap& gap, const Sphere& ball) {
  return gap.status == PairStatus::NotConverged || gap.distance <= kDoubt * ball.radius ||
         gap.distance - gap.lower > kDoubt * gap.distance;
}

/// The answer of a test that is more exact than a search.
enum class ExactAnswer { None, Apart, Touching };

ShapeDistance distance_after(ExactAnswer answer, const PlacedShapeView& a, const PlacedShapeView& b,
                             Work& work) {
  const PlacedMeshView mesh{*b.shape.as<Mesh>(), b.pose};
  const Eigen::Vector3d origin = middle_of(a.shape, a.pose);
  const Core core = core_of(a.shape, a.pose, origin);
  MeshDescent descent(mesh, core, origin, work);
  SetGap best{};
  best.distance = std::numeric_limits<double>::infinity();
  const std::optional<Sphere> ball = placed_ball(a, origin);
  std::uint32_t nearest = 0;
  double lower = best.distance;
  PairStatus status = PairStatus::Converged;
  descent.for_each_within([&] { return best.distance; },
                          [&](std::uint32_t index) {
                            SetGap gap = gap_of_sets(core, descent.triangle(index), best.distance);
                            ++work.convex_tests;
                            if (ball && is_in_doubt(gap, *ball))
                              gap = gap_of_ball(*ball, descent.placed_triangle(index));
                            if (gap.distance == 0) keep_apart(gap, core, descent, index);
                            lower = std::min(lower, gap.lower);
                            if (gap.status == PairStatus::NotConverged) {
                              ++work.convex_failures;
                              status = gap.status;
                            }
                            const bool is_tie = gap.distance == best.distance && index < nearest;
                            if (gap.distance < best.distance || is_tie) best = gap, nearest = index;
                            return bvh::Walk::Continue;
                          });
  const bool is_open = best.distance == 0 && best.status == PairStatus::NotConverged;
  if (answer == ExactAnswer::Apart && is_open) measure_apart(core, descent.triangle(nearest), best);
  const Vec3 o = to_vec3(origin);
  return {best.distance,         lower, to_eigen(best.point_a + o), to_eigen(best.point_b + o),
          to_eigen(best.normal), status};
}

}  // namespace

ShapeDistance distance_of_mesh_core(const PlacedShapeView& a, const PlacedShapeView& b,
                                    Work& work) {
  return distance_after(ExactAnswer::None, a, b, work);
}

ShapeDistance distance_of_mesh_volume(const PlacedShapeView& a, const PlacedShapeView& b,
                                      bool is_hit, Work& work) {
  const ExactAnswer answer = is_hit ? ExactAnswer::Touching : ExactAnswer::Apart;
  return agreeing(distance_after(answer, a, b, work), is_hit);
}

}  // namespace graze

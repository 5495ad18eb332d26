#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/rigid/first_hit.h>
#include <graze/engine/mesh/rigid/motion_query.h>
#include <graze/engine/mesh/rigid_contact.h>

namespace graze {
namespace {

/// True if there is a contact at this time of the grid, exactly.
bool is_hit(MotionQuery& query, std::uint64_t k) {
  const PlacedBodies& placed = query.pair.at(k);
  const PlacedMeshView placed_a(query.a.mesh, placed.pose_a), placed_b(query.b.mesh, placed.pose_b);
  if (query.settings.clearance == 0) return intersects(placed_a, placed_b, &query.work);
  return within(placed_a, placed_b, query.settings.clearance, {}, &query.work);
}

}  // namespace

RigidContact first_contact(const MeshInMotion& mesh_a, const MeshInMotion& mesh_b,
                           const RigidContactSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> RigidContact {
    CountedWork counted(work);
    MotionQuery query(mesh_a, mesh_b, settings, counted.work());
    const TimeGrid& grid = query.pair.grid();
    ContactWalk walk = query.walk(ContactWalk::End::AtFirst);
    const std::uint64_t low = walk.run();
    if (low == grid.end()) return {RigidStatus::Free, 1, 1, false};
    if (walk.is_out_of_budget()) return {RigidStatus::Close, grid.time(low), 1, true};
    const auto is_hit_at = [&](std::uint64_t k) { return is_hit(query, k); };
    if (const auto high = first_hit(low, grid.end(), is_hit_at))
      return {RigidStatus::Hit, grid.time(low), grid.time(*high), false};
    return {RigidStatus::Close, grid.time(low), 1, false};
  });
}

bool is_free(const MeshInMotion& mesh_a, const MeshInMotion& mesh_b,
             const RigidContactSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    CountedWork counted(work);
    MotionQuery query(mesh_a, mesh_b, settings, counted.work());
    ContactWalk walk = query.walk(ContactWalk::End::AtAny);
    return walk.run() == query.pair.grid().end();
  });
}

std::optional<double> last_free(const MeshInMotion& mesh_a, const MeshInMotion& mesh_b,
                                const RigidContactSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<double> {
    CountedWork counted(work);
    MotionQuery query(mesh_a, mesh_b, settings, counted.work());
    const TimeGrid& grid = query.pair.grid();
    ContactWalk walk = query.walk(ContactWalk::End::AtFirst);
    const std::uint64_t low = walk.run();
    if (low == grid.end()) return 1;
    if (low == 0) return std::nullopt;
    return grid.time(low - 1);
  });
}

}  // namespace graze

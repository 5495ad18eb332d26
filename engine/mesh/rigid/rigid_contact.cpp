#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/nearest/distance_parts.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/rigid/motion_query.h>
#include <graze/engine/mesh/rigid_contact.h>

#include <cmath>
#include <string>

namespace graze {
namespace {

/// Whether there is a contact at this time of the grid, exactly.
bool is_hit(MotionQuery& query, std::uint64_t k) {
  const PlacedBodies& placed = query.pair.at(k);
  const PlacedMeshView placed_a(query.a.mesh, placed.pose_a), placed_b(query.b.mesh, placed.pose_b);
  if (query.settings.clearance == 0) return intersects(placed_a, placed_b, &query.work);
  return within(placed_a, placed_b, query.settings.clearance, {}, &query.work);
}

/// A time from `low` on with a contact, if doubled steps come upon one.
std::optional<std::uint64_t> find_hit(MotionQuery& query, std::uint64_t low) {
  if (is_hit(query, low)) return low;
  const std::uint64_t end = query.pair.grid().end();
  std::uint64_t before = low;
  for (std::uint64_t step = 1; before < end; step *= 2) {
    std::uint64_t after = std::min(low + step, end);
    if (!is_hit(query, after)) {
      before = after;
      continue;
    }
    while (after - before > 1) {
      const std::uint64_t middle = before + (after - before) / 2;
      (is_hit(query, middle) ? after : before) = middle;
    }
    return after;
  }
  return std::nullopt;
}

}  // namespace

const RigidContactSettings& MotionQuery::checked(const RigidContactSettings& settings) {
  check_clearance(settings.clearance);
  if (settings.tolerance >= 0 && std::isfinite(settings.tolerance)) return settings;
  throw InputError("tolerance: " + std::to_string(settings.tolerance) + " is not a distance");
}

RigidContact first_contact(const Mesh& mesh_a, const RigidMotion& motion_a, const Mesh& mesh_b,
                           const RigidMotion& motion_b, const RigidContactSettings& settings,
                           Work* work) {
  return bvh::in_standard_arithmetic([&]() -> RigidContact {
    CountedWork counted(work);
    MotionQuery query(mesh_a, motion_a, mesh_b, motion_b, settings, counted.work());
    const TimeGrid& grid = query.pair.grid();
    ContactWalk walk = query.walk(ContactWalk::End::AtFirst);
    const std::uint64_t low = walk.run();
    if (low == grid.end()) return {RigidStatus::Free, 1, 1, false};
    if (walk.is_out_of_budget()) return {RigidStatus::Close, grid.time(low), 1, true};
    if (const auto high = find_hit(query, low))
      return {RigidStatus::Hit, grid.time(low), grid.time(*high), false};
    return {RigidStatus::Close, grid.time(low), 1, false};
  });
}

bool is_free(const Mesh& mesh_a, const RigidMotion& motion_a, const Mesh& mesh_b,
             const RigidMotion& motion_b, const RigidContactSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    CountedWork counted(work);
    MotionQuery query(mesh_a, motion_a, mesh_b, motion_b, settings, counted.work());
    ContactWalk walk = query.walk(ContactWalk::End::AtAny);
    return walk.run() == query.pair.grid().end();
  });
}

std::optional<double> last_free(const Mesh& mesh_a, const RigidMotion& motion_a, const Mesh& mesh_b,
                                const RigidMotion& motion_b, const RigidContactSettings& settings,
                                Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<double> {
    CountedWork counted(work);
    MotionQuery query(mesh_a, motion_a, mesh_b, motion_b, settings, counted.work());
    const TimeGrid& grid = query.pair.grid();
    ContactWalk walk = query.walk(ContactWalk::End::AtFirst);
    const std::uint64_t low = walk.run();
    if (low == grid.end()) return 1;
    if (low == 0) return std::nullopt;
    return grid.time(low - 1);
  });
}

}  // namespace graze

#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/nearest/distance_parts.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/rigid/contact_walk.h>
#include <graze/engine/mesh/rigid_contact.h>

#include <cmath>
#include <string>

namespace graze {
namespace {

void check_settings(const RigidContactSettings& settings) {
  check_clearance(settings.clearance);
  if (settings.tolerance >= 0 && std::isfinite(settings.tolerance)) return;
  throw InputError("tolerance: " + std::to_string(settings.tolerance) + " is not a distance");
}

/// What all questions about two motions begin with.
struct MotionQuery {
  MovingBody a;
  MovingBody b;
  MovingPair pair;
  const RigidContactSettings& settings;
  Work& work;

  MotionQuery(const Mesh& mesh_a, const RigidMotion& motion_a, const Mesh& mesh_b,
              const RigidMotion& motion_b, const RigidContactSettings& of_settings, Work& of_work)
      : a(mesh_a, motion_a, "motion of mesh A", of_work),
        b(mesh_b, motion_b, "motion of mesh B", of_work),
        pair(a, b, of_settings),
        settings(of_settings),
        work(of_work) {}

  /// Whether there is a contact at this time of the grid, exactly.
  bool is_hit(std::uint64_t k) {
    const PlacedBodies& placed = pair.at(k);
    const PlacedMeshView placed_a(a.mesh, placed.pose_a), placed_b(b.mesh, placed.pose_b);
    if (settings.clearance == 0) return intersects(placed_a, placed_b, &work);
    return within(placed_a, placed_b, settings.clearance, {}, &work);
  }

  /// A time from `low` on with a contact, if doubled steps come upon one.
  std::optional<std::uint64_t> find_hit(std::uint64_t low) {
    if (is_hit(low)) return low;
    const std::uint64_t end = pair.grid().end();
    std::uint64_t before = low;
    for (std::uint64_t step = 1; before < end; step *= 2) {
      std::uint64_t after = std::min(low + step, end);
      if (!is_hit(after)) {
        before = after;
        continue;
      }
      while (after - before > 1) {
        const std::uint64_t middle = before + (after - before) / 2;
        (is_hit(middle) ? after : before) = middle;
      }
      return after;
    }
    return std::nullopt;
  }
};

}  // namespace

RigidContact first_contact(const Mesh& mesh_a, const RigidMotion& motion_a, const Mesh& mesh_b,
                           const RigidMotion& motion_b, const RigidContactSettings& settings,
                           Work* work) {
  return bvh::in_standard_arithmetic([&]() -> RigidContact {
    CountedWork counted(work);
    check_settings(settings);
    MotionQuery query(mesh_a, motion_a, mesh_b, motion_b, settings, counted.work());
    const TimeGrid& grid = query.pair.grid();
    ContactWalk walk(query.pair, ContactWalk::End::AtFirst, settings.budget, counted.work());
    const std::uint64_t low = walk.run();
    if (low == grid.end()) return {RigidStatus::Free, 1, 1, false};
    if (walk.is_out_of_budget()) return {RigidStatus::Close, grid.time(low), 1, true};
    if (const auto high = query.find_hit(low))
      return {RigidStatus::Hit, grid.time(low), grid.time(*high), false};
    return {RigidStatus::Close, grid.time(low), 1, false};
  });
}

bool is_free(const Mesh& mesh_a, const RigidMotion& motion_a, const Mesh& mesh_b,
             const RigidMotion& motion_b, const RigidContactSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    CountedWork counted(work);
    check_settings(settings);
    MotionQuery query(mesh_a, motion_a, mesh_b, motion_b, settings, counted.work());
    ContactWalk walk(query.pair, ContactWalk::End::AtAny, settings.budget, counted.work());
    return walk.run() == query.pair.grid().end();
  });
}

std::optional<double> last_free(const Mesh& mesh_a, const RigidMotion& motion_a, const Mesh& mesh_b,
                                const RigidMotion& motion_b, const RigidContactSettings& settings,
                                Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<double> {
    CountedWork counted(work);
    check_settings(settings);
    MotionQuery query(mesh_a, motion_a, mesh_b, motion_b, settings, counted.work());
    const TimeGrid& grid = query.pair.grid();
    ContactWalk walk(query.pair, ContactWalk::End::AtFirst, settings.budget, counted.work());
    const std::uint64_t low = walk.run();
    if (low == grid.end()) return 1;
    if (low == 0) return std::nullopt;
    return grid.time(low - 1);
  });
}

}  // namespace graze

#pragma once

#include <graze/engine/world/world_update.h>

#include <cstddef>
#include <cstdint>

namespace graze::record {

/// Calls `visit(name, counter)` for each counter, in the order of the format.
template <typename Counters, typename Visit>
void for_each_counter(Counters& work, const Visit& visit) {
  visit("pairs_filtered", work.pairs_filtered);
  visit("pairs_at_rest", work.pairs_at_rest);
  visit("pairs_asleep", work.pairs_asleep);
  visit("pairs_apart", work.pairs_apart);
  visit("shape_tests", work.shape_tests);
  visit("gaps_measured", work.gaps_measured);
  visit("pairs_near", work.pairs_near);
  visit("contacts_found", work.contacts_found);
  visit("contacts_skipped", work.contacts_skipped);
  visit("islands_merged", work.islands_merged);
  visit("islands_split", work.islands_split);
  visit("island_steps", work.island_steps);
  visit("pairs_swept", work.pairs_swept);
  visit("trees_unbuilt", work.trees_unbuilt);
  auto& shapes = work.shapes;
  visit("volume_tests", shapes.volume_tests);
  visit("volume_rejections", shapes.volume_rejections);
  visit("filter_tests", shapes.filter_tests);
  visit("triangle_tests", shapes.triangle_tests);
  visit("exact_tests", shapes.exact_tests);
  visit("points_tested", shapes.points_tested);
  visit("skipped_by_memory", shapes.skipped_by_memory);
  visit("trees_built", shapes.trees_built);
  visit("treelets_built", shapes.treelets_built);
  visit("trees_refitted", shapes.trees_refitted);
  visit("treelets_refitted", shapes.treelets_refitted);
  visit("triangles_rebuilt", shapes.triangles_rebuilt);
  visit("skins_built", shapes.skins_built);
  visit("convex_tests", shapes.convex_tests);
  visit("convex_failures", shapes.convex_failures);
  visit("penetration_tests", shapes.penetration_tests);
  visit("penetration_failures", shapes.penetration_failures);
}

inline constexpr std::size_t kCounters = 31;
static_assert(sizeof(WorldWork) == kCounters * sizeof(std::uint64_t), "a counter is not kept");

}  // namespace graze::record

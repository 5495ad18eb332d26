#include <graze/engine/values/text.h>
#include <graze/print.h>

#include <cstdint>
#include <ostream>

namespace graze {
namespace {

struct Counter {
  const char* name;
  std::uint64_t count;
};

/// Writes the counters that are not 0.
template <std::size_t N>
Text text_of(const Counter (&counters)[N]) {
  Text text;
  for (const auto& [name, count] : counters) {
    if (count == 0) continue;
    text.add(text.str().empty() ? "" : ", "), text.add(count), text.add(" "), text.add(name);
  }
  return text;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Work& work) {
  const Counter counters[] = {
      {"volume tests", work.volume_tests},
      {"volume rejections", work.volume_rejections},
      {"filter tests", work.filter_tests},
      {"triangle tests", work.triangle_tests},
      {"exact tests", work.exact_tests},
      {"points tested", work.points_tested},
      {"skipped by memory", work.skipped_by_memory},
      {"trees built", work.trees_built},
      {"treelets built", work.treelets_built},
      {"trees refitted", work.trees_refitted},
      {"treelets refitted", work.treelets_refitted},
      {"triangles rebuilt", work.triangles_rebuilt},
      {"skins built", work.skins_built},
      {"convex tests", work.convex_tests},
      {"convex failures", work.convex_failures},
      {"penetration tests", work.penetration_tests},
      {"penetration failures", work.penetration_failures},
  };
  static_assert(sizeof(counters) / sizeof(counters[0]) == sizeof(Work) / sizeof(std::uint64_t));
  const Text text = text_of(counters);
  return out << (text.str().empty() ? Text("no work") : text);
}
std::ostream& operator<<(std::ostream& out, const WorldWork& work) {
  const Counter counters[] = {
      {"pairs filtered", work.pairs_filtered},
      {"pairs at rest", work.pairs_at_rest},
      {"pairs asleep", work.pairs_asleep},
      {"pairs apart", work.pairs_apart},
      {"shape tests", work.shape_tests},
      {"gaps measured", work.gaps_measured},
      {"pairs near", work.pairs_near},
      {"contacts found", work.contacts_found},
      {"contacts skipped", work.contacts_skipped},
      {"islands merged", work.islands_merged},
      {"islands split", work.islands_split},
      {"island steps", work.island_steps},
      {"pairs swept", work.pairs_swept},
      {"trees unbuilt", work.trees_unbuilt},
  };
  static_assert(sizeof(counters) / sizeof(counters[0]) ==
                (sizeof(WorldWork) - sizeof(Work)) / sizeof(std::uint64_t));
  const Text text = text_of(counters);
  if (text.str().empty()) return out << work.shapes;
  return work.shapes == Work{} ? out << text : out << text << Text(", ") << work.shapes;
}
std::ostream& operator<<(std::ostream& out, const BroadPhaseWork& work) {
  const Counter counters[] = {
      {"updates", work.updates},
      {"searches for all", work.searches_for_all},
      {"searches for movers", work.searches_for_movers},
      {"sorts", work.sorts},
      {"groups sorted", work.groups_sorted},
      {"blocks met", work.blocks_met},
  };
  static_assert(sizeof(counters) / sizeof(counters[0]) ==
                sizeof(BroadPhaseWork) / sizeof(std::uint64_t));
  const Text text = text_of(counters);
  return out << (text.str().empty() ? Text("no work") : text);
}

}  // namespace graze

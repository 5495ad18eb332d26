#pragma once

#include <graze/engine/world/bodies/world_state.h>

#include <algorithm>
#include <limits>

namespace graze {

/// The largest of all distances, and what is beyond it: the distance to a body that is not there.
inline constexpr double kLargestDistance = std::numeric_limits<double>::max();
inline constexpr double kBeyondAll = std::numeric_limits<double>::infinity();

/// Calls `ask(index)` for bodies that are asked for, each once, until none that is left can be
/// nearer to a box than what `ask` says is the least distance so far, `least` before it was ever
/// asked. Looks in boxes that grow until the nearest body is nearer than all outside can be; which
/// it is in a box that is grown by its distance.
template <typename Ask>
void World::State::for_nearest(const Aabb& own, const BodyQuerySettings& query, double least,
                               const Ask& ask) const {
  std::vector<std::uint32_t> seen;  // ascending
  for (double width = least <= kLargestDistance ? least : width_of(own);; width *= 4) {
    const bool is_all = !(width < kLargestDistance);
    std::vector<std::uint32_t> found =
        find_bodies(grown(own, std::min(width, kLargestDistance)), query);
    for (const std::uint32_t index : found) {
      if (!std::binary_search(seen.begin(), seen.end(), index)) least = ask(index);
    }
    seen = std::move(found);
    if (is_all || least <= width || seen.size() == all.ids.live_count()) return;
    if (least <= kLargestDistance) width = least / 4;
  }
}

}  // namespace graze

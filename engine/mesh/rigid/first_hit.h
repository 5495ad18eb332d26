#pragma once

// This finds witnesses. It is private to the library.

#include <algorithm>
#include <cstdint>
#include <optional>

namespace graze {

/// Returns a time k from `low` to `end` with `is_hit(k)`, if steps that double come upon one, and
/// narrows it to one that the time before it has not. A hit that lasts as long as it took to come
/// there is found.
template <typename IsHit>
std::optional<std::uint64_t> first_hit(std::uint64_t low, std::uint64_t end, const IsHit& is_hit) {
  if (is_hit(low)) return low;
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

}  // namespace graze

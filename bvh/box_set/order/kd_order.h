#pragma once

#include <graze/bvh/box_set/store/block.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

namespace graze::bvh {

/// Returns the middle between two keys of ordered_box(), from an origin that precision does not ask
/// much of. It is rounded, but always finite.
static inline float centre(std::int64_t low, std::int64_t high, double origin) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  const double value = 0.5 * value_of_key(low) + 0.5 * value_of_key(high) - origin;
  return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

/// A box to be put in order: its centre, rounded, and its proxy, which decides between equal ones.
struct KdItem {
  float centre[3];
  std::uint32_t proxy;
};

/// Puts items into an order in which every 16 consecutive ones lie together, and every 16 of such
/// blocks, and so on: by cutting at the median of the longest side until a block is left, each cut
/// at a whole number of the largest subtrees. The order follows from the items as they come, and
/// from the order of no library. It runs on the threads of the caller's arena, in O(n log n).
void kd_order(std::span<KdItem> items);

}  // namespace graze::bvh

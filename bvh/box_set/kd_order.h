#pragma once

#include <cstdint>
#include <span>

namespace graze::bvh {

/// A box to be put in order: its centre, rounded, and its owner, which decides between equal ones.
struct KdItem {
  float centre[3];
  std::uint32_t owner;
};

/// Puts items into an order in which every 16 consecutive ones lie together, and every 16 of such
/// blocks, and so on: by cutting at the median of the longest side until a block is left, each cut
/// at a whole number of the largest subtrees. The order follows from the items as they come, and
/// from no library's. Runs on the threads of the caller's arena. O(n log n).
void kd_order(std::span<KdItem> items);

}  // namespace graze::bvh

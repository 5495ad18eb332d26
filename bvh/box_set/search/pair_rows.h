#pragma once

#include <graze/bvh/box_set/search/pair_buffer.h>

#include <cstdint>
#include <vector>

namespace graze::bvh {

/// Pairs grouped by their first index: row a is a list of pairs (a, b), in the order in which they
/// came.
class PairRows {
 public:
  /// All indices are below `index_count`. O(pairs + index_count).
  void group(std::span<const BoxPair> pairs, std::uint32_t index_count);

  std::uint32_t row_count() const { return static_cast<std::uint32_t>(ends_.size()); }
  /// Empty beyond the last row.
  std::span<const BoxPair> row(std::uint32_t a) const {
    if (a >= ends_.size()) return {};
    const std::uint32_t first = a == 0 ? 0 : ends_[a - 1];
    return pairs_.pairs().subspan(first, ends_[a] - first);
  }
  std::size_t bytes() const {
    return pairs_.capacity() * sizeof(BoxPair) + ends_.capacity() * sizeof(std::uint32_t);
  }

 private:
  PairBuffer pairs_;
  std::vector<std::uint32_t> ends_;
};

/// Working memory.
struct RowsToSort {
  std::vector<BoxPair> left, right;
};

/// Appends what is in `now` alone to `begun`, and what is in `before` alone to `ended`, ascending.
/// From one search to the next most rows are the same, and in the same order: then nothing is
/// sorted.
void append_changes(const PairRows& before, const PairRows& now, RowsToSort& memory,
                    PairBuffer& begun, PairBuffer& ended);

}  // namespace graze::bvh

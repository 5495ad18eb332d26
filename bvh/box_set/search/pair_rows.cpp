#include <graze/bvh/box_set/search/pair_rows.h>
#include <graze/bvh/box_set/search/sorted_pairs.h>

#include <algorithm>
#include <utility>

namespace graze::bvh {

void PairRows::group(std::span<const BoxPair> pairs, std::uint32_t index_count) {
  ends_.assign(index_count, 0);
  for (const BoxPair& pair : pairs)
    ++ends_[pair.a];
  std::uint32_t first = 0;
  for (std::uint32_t& end : ends_)
    first += std::exchange(end, first);
  // Each entry is where its row begins, and moves to where it ends.
  pairs_.resize(pairs.size());
  for (const BoxPair& pair : pairs)
    pairs_.data()[ends_[pair.a]++] = pair;
}

void append_changes(const PairRows& before, const PairRows& now, RowsToSort& memory,
                    PairBuffer& begun, PairBuffer& ended) {
  const std::uint32_t count = std::max(before.row_count(), now.row_count());
  for (std::uint32_t a = 0; a < count; ++a) {
    const std::span<const BoxPair> left = before.row(a), right = now.row(a);
    if (std::equal(left.begin(), left.end(), right.begin(), right.end())) continue;
    memory.left.assign(left.begin(), left.end());
    memory.right.assign(right.begin(), right.end());
    std::sort(memory.left.begin(), memory.left.end());
    std::sort(memory.right.begin(), memory.right.end());
    append_difference(memory.right, memory.left, begun);
    append_difference(memory.left, memory.right, ended);
  }
}

}  // namespace graze::bvh

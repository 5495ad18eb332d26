#include <graze/bvh/box_set/search/pair_lists.h>

#include <utility>

namespace graze::bvh {
namespace {

/// Puts pairs that begin with the same index beside each other, in the order in which they come:
/// those of index a end where ends[a] says, and begin where those of the index before end.
void group_by_first(std::span<const BoxPair> pairs, std::uint32_t index_count,
                    std::vector<std::uint32_t>& ends, PairBuffer& grouped) {
  ends.assign(index_count, 0);
  for (const BoxPair& pair : pairs)
    ++ends[pair.a];
  std::uint32_t first = 0;
  for (std::uint32_t& end : ends)
    first += std::exchange(end, first);
  // Each entry is where its row begins, and moves to where it ends.
  grouped.resize(pairs.size());
  for (const BoxPair& pair : pairs)
    grouped.data()[ends[pair.a]++] = pair;
}

/// Appends what is in `left` and not in `right`, both sorted.
void append_difference(std::span<const BoxPair> left, std::span<const BoxPair> right,
                       PairBuffer& out) {
  auto other = right.begin();
  for (const BoxPair& pair : left) {
    while (other != right.end() && *other < pair)
      ++other;
    if (other == right.end() || *other != pair) out.push_back(pair);
  }
}

}  // namespace

void sort_pairs(std::span<const BoxPair> pairs, std::uint32_t index_count,
                std::vector<std::uint32_t>& ends, PairBuffer& sorted) {
  group_by_first(pairs, index_count, ends, sorted);
  std::uint32_t first = 0;
  for (const std::uint32_t end : ends) {
    if (end - first > 1) std::sort(sorted.data() + first, sorted.data() + end);
    first = end;
  }
}

void PairRows::group(std::span<const BoxPair> pairs, std::uint32_t index_count) {
  group_by_first(pairs, index_count, ends_, pairs_);
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

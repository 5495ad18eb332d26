#include <graze/bvh/box_set/search/sorted_pairs.h>

#include <algorithm>

namespace graze::bvh {

void sort_pairs(std::span<const BoxPair> pairs, std::uint32_t index_count,
                std::vector<std::uint32_t>& starts, PairBuffer& sorted) {
  starts.assign(std::size_t{index_count} + 1, 0);
  for (const BoxPair& pair : pairs)
    ++starts[pair.a + std::size_t{1}];
  for (std::size_t i = 1; i < starts.size(); ++i)
    starts[i] += starts[i - 1];
  sorted.resize(pairs.size());
  for (const BoxPair& pair : pairs)
    sorted.data()[starts[pair.a]++] = pair;
  // Now starts[a] is the end of row a.
  std::uint32_t first = 0;
  for (std::uint32_t a = 0; a < index_count; ++a) {
    if (starts[a] - first > 1) std::sort(sorted.data() + first, sorted.data() + starts[a]);
    first = starts[a];
  }
}

void append_difference(std::span<const BoxPair> left, std::span<const BoxPair> right,
                       PairBuffer& out) {
  auto other = right.begin();
  for (const BoxPair& pair : left) {
    while (other != right.end() && *other < pair)
      ++other;
    if (other == right.end() || *other != pair) out.push_back(pair);
  }
}

}  // namespace graze::bvh

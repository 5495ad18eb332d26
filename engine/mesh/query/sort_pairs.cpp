#include <graze/engine/mesh/query/sort_pairs.h>
#include <hwy/contrib/sort/vqsort.h>

#include <algorithm>
#include <cstdint>
#include <span>

namespace graze {
namespace {

constexpr std::size_t kFewest = 8;  // measured

/// Returns one number for both indices.
std::uint64_t number_of(TrianglePair pair) {
  return (std::uint64_t{pair.a} << 32) | pair.b;
}

TrianglePair pair_of(std::uint64_t number) {
  return {static_cast<std::uint32_t>(number >> 32), static_cast<std::uint32_t>(number)};
}

void sort_few(std::span<TrianglePair> pairs) {
  std::uint64_t numbers[kMostToRank];
  std::uint64_t sorted[kMostToRank];
  std::transform(pairs.begin(), pairs.end(), numbers, number_of);
  if (rank_sort({numbers, pairs.size()}, sorted)) {
    std::transform(sorted, sorted + pairs.size(), pairs.begin(), pair_of);
  } else {
    std::sort(pairs.begin(), pairs.end());
  }
}

}  // namespace

void sort_pairs(std::vector<TrianglePair>& pairs) {
  if (pairs.size() < kFewest) return std::sort(pairs.begin(), pairs.end());
  if (pairs.size() <= kMostToRank) return sort_few(pairs);
  std::vector<std::uint64_t> numbers(pairs.size());
  std::transform(pairs.begin(), pairs.end(), numbers.begin(), number_of);
  hwy::Sorter()(numbers.data(), numbers.size(), hwy::SortAscending());
  std::transform(numbers.begin(), numbers.end(), pairs.begin(), pair_of);
}

}  // namespace graze

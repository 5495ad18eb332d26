#include <graze/engine/mesh/sort_pairs.h>
#include <hwy/contrib/sort/vqsort.h>

#include <algorithm>
#include <cstdint>

namespace graze {

void sort_pairs(std::vector<TrianglePair>& pairs) {
  constexpr std::size_t kFew = 200;  // measured
  if (pairs.size() < kFew) {
    std::sort(pairs.begin(), pairs.end());
    return;
  }
  // One number for both indices.
  std::vector<std::uint64_t> numbers(pairs.size());
  std::transform(pairs.begin(), pairs.end(), numbers.begin(),
                 [](TrianglePair pair) { return (std::uint64_t{pair.a} << 32) | pair.b; });
  hwy::Sorter()(numbers.data(), numbers.size(), hwy::SortAscending());
  std::transform(numbers.begin(), numbers.end(), pairs.begin(), [](std::uint64_t number) {
    return TrianglePair{static_cast<std::uint32_t>(number >> 32),
                        static_cast<std::uint32_t>(number)};
  });
}

}  // namespace graze

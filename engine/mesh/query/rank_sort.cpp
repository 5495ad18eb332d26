// This sorts by rank for each SIMD target that the compiler knows.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/engine/mesh/query/rank_sort.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/engine/mesh/query/sort_pairs.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace graze::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

bool rank_sort(std::span<const std::uint64_t> numbers, std::uint64_t* sorted) {
  constexpr std::size_t kMostLanes = 8;
  const hn::CappedTag<std::uint64_t, kMostLanes> tag;
  const std::size_t size = numbers.size();
  std::size_t sum = 0;
  for (std::size_t first = 0; first < size; first += hn::Lanes(tag)) {
    const std::size_t count = std::min(hn::Lanes(tag), size - first);
    const std::uint64_t* lanes = numbers.data() + first;
    alignas(64) std::uint64_t rest[kMostLanes] = {};
    if (count < hn::Lanes(tag)) {
      std::copy_n(lanes, count, rest);
      lanes = rest;
    }
    const auto some = hn::LoadU(tag, lanes);
    auto rank = hn::Zero(tag);
    for (const std::uint64_t other : numbers)
      rank = hn::Sub(rank, hn::VecFromMask(tag, hn::Lt(hn::Set(tag, other), some)));
    alignas(64) std::uint64_t ranks[kMostLanes];
    hn::Store(rank, tag, ranks);
    for (std::size_t lane = 0; lane < count; ++lane) {
      sorted[ranks[lane]] = lanes[lane];
      sum += ranks[lane];
    }
  }
  // Equal numbers have the rank of the first of them, and leave a gap.
  return sum == size * (size - 1) / 2;
}

}  // namespace
}  // namespace graze::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze {

HWY_EXPORT(rank_sort);

bool rank_sort(std::span<const std::uint64_t> numbers, std::uint64_t* sorted) {
  return HWY_DYNAMIC_DISPATCH(rank_sort)(numbers, sorted);
}

}  // namespace graze
#endif

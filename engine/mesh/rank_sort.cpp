// Sorting by rank for each SIMD target that the compiler knows.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/engine/mesh/rank_sort.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/engine/mesh/rank_sort.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace graze::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

bool rank_sort(std::span<const std::uint64_t> numbers, std::uint64_t* sorted) {
  const hn::CappedTag<std::uint64_t, 8> tag;
  const std::size_t size = numbers.size();
  std::size_t sum = 0;
  for (std::size_t first = 0; first < size; first += hn::Lanes(tag)) {
    const auto is_there = hn::FirstN(tag, size - first);
    const auto some = hn::MaskedLoad(is_there, tag, numbers.data() + first);
    auto rank = hn::Zero(tag);
    for (const std::uint64_t other : numbers)
      rank = hn::Sub(rank, hn::VecFromMask(tag, hn::Lt(hn::Set(tag, other), some)));
    alignas(64) std::uint64_t ranks[8];
    hn::Store(rank, tag, ranks);
    for (std::size_t lane = 0; lane < hn::Lanes(tag) && first + lane < size; ++lane) {
      sorted[ranks[lane]] = numbers[first + lane];
      sum += ranks[lane];
    }
  }
  // What is equal has the rank of the first of these, and leaves a gap.
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

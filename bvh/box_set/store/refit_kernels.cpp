// These compute the bounds of blocks for each SIMD target that the compiler knows; the widest that
// the CPU has is chosen when the program runs. They compare integers, so that all of them agree.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/box_set/store/refit_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/box_set/store/layer.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<std::int32_t, kLanes>;
using Lanes = hn::Vec<Tag>;

template <typename Join, typename Reduce>
HWY_INLINE std::int32_t reduce_row(const std::int32_t* row, const Join& join,
                                   const Reduce& reduce) {
  const Tag tag;
  Lanes all = hn::Load(tag, row);
  for (std::uint32_t lane = static_cast<std::uint32_t>(hn::Lanes(tag)); lane < kLanes;
       lane += static_cast<std::uint32_t>(hn::Lanes(tag)))
    all = join(all, hn::Load(tag, row + lane));
  return hn::GetLane(reduce(all));
}

void refit_blocks(const Block* below, std::uint32_t first, std::uint32_t last, Block* above) {
  const Tag tag;
  for (std::uint32_t i = first; i < last; ++i) {
    Block& parent = above[i >> kLaneBits];
    const std::uint32_t lane = i & (kLanes - 1);
    for (int c = 0; c < 3; ++c) {
      parent.row[c][lane] = reduce_row(
          below[i].row[c], [](Lanes x, Lanes y) { return hn::Min(x, y); },
          [&](Lanes x) { return hn::MinOfLanes(tag, x); });
      parent.row[c + 3][lane] = reduce_row(
          below[i].row[c + 3], [](Lanes x, Lanes y) { return hn::Max(x, y); },
          [&](Lanes x) { return hn::MaxOfLanes(tag, x); });
    }
  }
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(refit_blocks);

void refit_blocks(const Block* below, std::uint32_t first, std::uint32_t last, Block* above) {
  HWY_DYNAMIC_DISPATCH(refit_blocks)(below, first, last, above);
}

}  // namespace graze::bvh
#endif

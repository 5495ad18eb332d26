// The walk over two wide trees, for each SIMD target that the compiler knows.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/wide/walk/wide_pair_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/wide/walk/pair_walker-inl.h>
#include <graze/bvh/wide/walk/wide_any_kernels.h>
#include <graze/bvh/wide/walk/wide_pair_walk.h>
#include <hwy/highway.h>

#include <cstddef>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

std::size_t walk(WidePairWalk::State& state, std::span<FoundPair> found, WideWalkCounts& counts) {
  return Walker<Goal::AllPairs>(state, found, counts).run();
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(walk);

WidePairWalk::WidePairWalk(const WideTree& tree_a, const WideTree& tree_b,
                           const RelativeFrame& b_in_a, const RelativeFrame& a_in_b, Goal goal)
    : goal_(goal), state_(tree_a, tree_b, b_in_a, a_in_b) {
  state_.open.push({tree_a.root(), tree_b.root()});
}

std::size_t WidePairWalk::next(std::span<FoundPair> found) {
  if (goal_ == Goal::AnyPair) return next_of_any(state_, found, counts_);
  return HWY_DYNAMIC_DISPATCH(walk)(state_, found, counts_);
}

}  // namespace graze::bvh
#endif

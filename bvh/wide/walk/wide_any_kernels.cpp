// A walk over two wide trees that any pair ends, for each SIMD target that the compiler knows.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/wide/walk/wide_any_kernels.cpp"
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

std::size_t walk_to_any(WidePairWalk::State& state, std::span<FoundPair> found,
                        WideWalkCounts& counts) {
  return Walker<Goal::AnyPair>(state, found, counts).run_to_any();
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(walk_to_any);

std::size_t next_of_any(WidePairWalk::State& state, std::span<FoundPair> found,
                        WideWalkCounts& counts) {
  return HWY_DYNAMIC_DISPATCH(walk_to_any)(state, found, counts);
}

}  // namespace graze::bvh
#endif

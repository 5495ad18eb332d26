#pragma once

#include <graze/bvh/wide/walk/wide_pair_walk.h>

#include <cstddef>
#include <span>

namespace graze::bvh {

/// WidePairWalk::next() of a walk that any pair ends. Compiled apart from the walk to all pairs,
/// which is slower where the compiler sees both.
std::size_t next_of_any(WidePairWalk::State& state, std::span<FoundPair> found,
                        WideWalkCounts& counts);

}  // namespace graze::bvh

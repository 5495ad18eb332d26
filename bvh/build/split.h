#pragma once

#include <graze/bvh/build/build.h>
#include <graze/bvh/build/part.h>

namespace graze::bvh {

/// The results of split().
enum class SplitResult { Leaf, Inner };

/// Reorders the references of a part of at least two so that its two sides lie one behind the
/// other, unless a leaf is allowed and cheaper. From a depth of 64 on the sides are halves by
/// count, whatever the heuristic says. What comes out depends on the part, its depth and the order
/// of its references alone.
SplitResult split(std::span<Reference> references, const Part& part, const BuildSettings& settings,
                  Part (&sides)[2]);

}  // namespace graze::bvh

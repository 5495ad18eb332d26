#pragma once

#include <graze/bvh/build/build.h>
#include <graze/bvh/build/part.h>
#include <vector>

namespace graze::bvh {

/// If there are at most this many references, all trees over them are weighed.
constexpr std::size_t kSmallSubtree = 4;

/// Builds the cheapest of all trees over a part of 2 to kSmallSubtree references, with any of them
/// apart from any others, by the surface area heuristic. Its root is nodes[at], which has its box
/// already; the others are appended, depth first. Each leaf's `first` counts from references[0].
void build_small_subtree(std::span<Reference> references, const Part& part,
                         const BuildSettings& settings, std::size_t at, std::vector<Node>& nodes);

}  // namespace graze::bvh

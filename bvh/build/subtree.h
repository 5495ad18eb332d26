#pragma once

#include <graze/bvh/build/build.h>
#include <graze/bvh/build/part.h>
#include <vector>

namespace graze::bvh {

/// Returns the nodes of the tree over a part, its root first, depth first, the children of a node
/// side by side behind it. The references of the part are put in the order of the leaves, in which
/// each leaf's `first` counts from the part's begin. The result depends on the part, its depth and
/// the order of its references alone, so that it may be built at any time, by any thread that has
/// them to itself.
std::vector<Node> build_subtree(std::span<Reference> references, const Part& part,
                                const BuildSettings& settings);

}  // namespace graze::bvh

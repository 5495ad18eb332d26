#pragma once

#include <graze/bvh/build/build.h>
#include <graze/bvh/build/reference.h>
#include <vector>

namespace graze::bvh {

/// Returns the nodes of a tree, or of a subtree with `depth` nodes above it, over references, which
/// are given up as soon as they have served. Writes their indices to `primitives` in the order of
/// the leaves. It is parallel; the result is the same for any number of threads.
std::vector<Node> build_nodes(References references, int depth, const BuildSettings& settings,
                              std::span<std::uint32_t> primitives);

}  // namespace graze::bvh

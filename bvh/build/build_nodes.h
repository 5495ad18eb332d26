#pragma once

#include <graze/bvh/build/build.h>
#include <graze/bvh/build/reference.h>
#include <vector>

namespace graze::bvh {

/// The nodes of a tree, or of a subtree with `depth` nodes above it, over references, which are
/// given up as soon as they have served. Writes their indices to `primitives` in the order of the
/// leaves. Parallel; the same for any number of threads.
std::vector<Node> build_nodes(References references, int depth, const BuildSettings& settings,
                              std::span<std::uint32_t> primitives);

}  // namespace graze::bvh

#pragma once

// This puts the leaves of a RayTree into its memory. It is private.

#include <graze/bvh/rays/ray_tree.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace graze::bvh {

/// What leaves are made of. A leaf among the nodes tells the places of its primitives.
struct LeafSource {
  const Tree& tree;
  std::span<const RayNode> nodes;
  const LocalCorners& corners;
};

/// Returns at which word each leaf that shares points begins, in the order of nodes and lanes, and
/// at last where they end. Returns nothing if they do not fit into `most_words`, or cannot be told.
std::optional<std::vector<std::uint32_t>> shared_leaves(const LeafSource& source,
                                                        std::size_t most_words);

/// Fills in the leaves of the node with that index in the words that begin at `to`.
void fill_corners(const LeafSource& source, std::size_t node, std::uint32_t* to);

/// Does the same for leaves that share points. `node` tells at which words they begin.
void fill_shared_points(const LeafSource& source, std::size_t index, const RayNode& node,
                        std::uint32_t* to);

}  // namespace graze::bvh

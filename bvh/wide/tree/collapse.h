#pragma once

#include <graze/bvh/tree/tree.h>
#include <graze/bvh/wide/tree/fit_node.h>
#include <graze/bvh/wide/tree/wide_tree.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// The topology of a wide node: the binary nodes that became its children, in the order of their
/// primitives.
struct WideTopologyNode {
  std::uint32_t child[WideNode::kWidth];  ///< the children's links as ChildLink packs them
  std::uint32_t node[WideNode::kWidth];   ///< the binary node of each child
  PrimitiveRange range[WideNode::kWidth];
  std::uint32_t count;
};

/// Collapses binary nodes, of which the first is the root, into the wide ones that are visited
/// least as the surface area heuristic has it, and few of them: the cheapest forests of up to eight
/// roots, from the leaves up (Ylitie, Karras, Laine, "Efficient incoherent ray traversal on GPUs
/// through compressed wide BVHs", 2017, section 3). Parents stand before their children. A single
/// leaf becomes a node of one child.
std::vector<WideTopologyNode> collapse(std::span<const Node> nodes);

}  // namespace graze::bvh

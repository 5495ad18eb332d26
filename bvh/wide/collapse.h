#pragma once

#include <graze/bvh/tree.h>
#include <graze/bvh/wide/fit_node.h>
#include <graze/bvh/wide/wide_node.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// The topology of wide nodes: which binary nodes became children of which wide node, in the order
/// of their primitives.
struct WideTopologyNode {
  std::uint32_t child[WideNode::kWidth];  ///< ChildLink: of nodes in the returned vector, or leaves
  PrimitiveRange range[WideNode::kWidth];
  std::uint32_t count;
};

/// Collapses binary nodes, of which the first is the root, into wide ones: the child with the
/// largest surface is replaced by its own children until there are eight. Parents stand before
/// their children. A single leaf becomes a node of one child.
std::vector<WideTopologyNode> collapse(std::span<const Node> nodes);

}  // namespace graze::bvh

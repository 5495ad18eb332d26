#pragma once

// Building and refitting of treelets share this. It is private to bvh/wide.

#include <graze/bvh/wide/tree/collapse.h>
#include <graze/bvh/wide/tree/corner_source.h>
#include <graze/bvh/wide/tree/fit_node.h>
#include <graze/bvh/wide/tree/wide_tree.h>

#include <cstdint>
#include <span>

namespace graze::bvh {

/// The primitives of one treelet where they are, and an origin in the middle of them.
struct TreeletCorners {
  TreeletCorners(const TreeletPart& part, std::span<const std::uint32_t> order,
                 const LocalFrame& frame, const CornerSource& source);

  double origin[3];
  CornerRows rows;
};

/// Returns the ranges of a node's children, as fit_node() takes them.
inline std::span<const PrimitiveRange> ranges_of(const WideTopologyNode& node) {
  return {node.range, node.count};
}

/// Moves the corners into the treelet, leaf by leaf.
void set_corners(Treelet& treelet, const TreeletPart& part, const TreeletCorners& corners,
                 std::span<const WideTopologyNode> topology);

/// Returns how many boxes a line that meets a primitive has to expect, where all boxes have these
/// surfaces: per area of the primitives, which no rotation changes, as it would the box of all of
/// them.
float cost_of(double surfaces, const TreeletCorners& corners);

/// Fits axes and boxes to all nodes, whose links are set, and says what that costs.
float fit_nodes(Treelet& treelet, const TreeletCorners& corners,
                std::span<const WideTopologyNode> topology);

}  // namespace graze::bvh

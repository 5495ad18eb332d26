#pragma once

// What building and refitting of treelets share. Private to bvh/wide.

#include <graze/bvh/wide/collapse.h>
#include <graze/bvh/wide/corner_source.h>
#include <graze/bvh/wide/fit_node.h>
#include <graze/bvh/wide/treelet.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// The primitives of one treelet where they are, and an origin in the middle of them.
struct TreeletCorners {
  TreeletCorners(const TreeletPart& part, std::span<const std::uint32_t> order,
                 const LocalFrame& frame, const CornerSource& source);

  double origin[3];
  CornerRows rows;
};

/// What makes up the cost of a treelet, node by node, the first being its root.
class TreeletCost {
 public:
  void add(const FittedSurfaces& node) {
    if (children_ == 0) root_ = node.all;
    children_ += node.children;
  }

  /// How many nodes and leaves a line through the root's box meets.
  float value() const { return root_ > 0 ? children_ / root_ : 1; }

 private:
  float root_ = 0;
  float children_ = 0;
};

/// The ranges of a node's children, as fit_node() takes them.
inline std::span<const PrimitiveRange> ranges_of(const WideTopologyNode& node) {
  return {node.range, node.count};
}

/// Moves the corners into the treelet, leaf by leaf.
void set_corners(Treelet& treelet, const TreeletPart& part, const TreeletCorners& corners,
                 std::span<const WideTopologyNode> topology);

/// Fits axes and boxes to all nodes, whose links are set, and says what that costs.
float fit_nodes(Treelet& treelet, const TreeletCorners& corners,
                std::span<const WideTopologyNode> topology);

}  // namespace graze::bvh

#include <graze/bvh/build/part.h>
#include <graze/bvh/build/subtree.h>
#include <graze/bvh/wide/tree/collapse.h>
#include <graze/bvh/wide/tree/fit_slabs.h>
#include <graze/bvh/wide/tree/treelet_build.h>
#include <graze/bvh/wide/tree/treelet_fit.h>
#include <graze/bvh/wide/tree/wide_bounds.h>

#include <algorithm>

namespace graze::bvh {
namespace {

void set_lane(WideNode& node, std::uint32_t lane, const FloatBox& box, std::uint32_t link) {
  for (int k = 0; k < 3; ++k) {
    node.centre[k][lane] = 0.5f * (box.min[k] + box.max[k]);
    // This is room for the rounding of the centre, and a margin as in wide_bounds.h: local boxes
    // are below 2.
    node.half[k][lane] = rounded_up(0.5 * box.max[k] - 0.5 * box.min[k] + 16 * kFitError);
  }
  clear_slab(node, lane);
  node.child[lane] = link;
}

WideNode node_along_coordinates(std::uint32_t count) {
  WideNode node{};
  for (int k = 0; k < 3; ++k)
    node.axes[k][k] = 1;
  node.count = static_cast<std::uint16_t>(count);
  return node;
}

/// Puts the primitives in the order of the leaves of the binary tree over them, and returns its
/// nodes.
std::vector<Node> ordered_nodes(const TreeletPart& part, std::span<std::uint32_t> order,
                                const LocalFrame& frame, const CornerSource& source) {
  References references = source.references(frame, order);
  std::vector<Node> nodes = build_subtree(
      references.all(), part_of(references.all(), 0, references.size, part.depth), kWideSettings);
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = references.data[i].index();
  return nodes;
}

}  // namespace

std::vector<WideNode> top_nodes(std::span<const Node> top, const FloatBox& box) {
  std::vector<WideNode> nodes{node_along_coordinates(1)};
  if (top.size() == 1) {
    set_lane(nodes[0], 0, box, ChildLink::to_treelet(1));
    return nodes;
  }
  set_lane(nodes[0], 0, box, ChildLink::to_node(1));
  for (const WideTopologyNode& wide : collapse(top)) {
    WideNode node = node_along_coordinates(wide.count);
    for (std::uint32_t j = 0; j < wide.count; ++j) {
      const Node& binary = top[wide.node[j]];
      set_lane(node, j, binary.box,
               binary.is_leaf() ? ChildLink::to_treelet(binary.first + 1)
                                : ChildLink::to_node(wide.child[j]));
    }
    nodes.push_back(node);
  }
  return nodes;
}

Treelet built_treelet(const TreeletPart& part, std::span<std::uint32_t> order,
                      const LocalFrame& frame, const CornerSource& source) {
  const std::vector<WideTopologyNode> topology =
      collapse(ordered_nodes(part, order, frame, source));
  const TreeletCorners corners(part, order, frame, source);
  Treelet treelet;
  treelet.nodes.resize(topology.size());
  for (std::size_t i = 0; i < topology.size(); ++i)
    std::copy_n(topology[i].child, WideNode::kWidth, treelet.nodes[i].child);
  treelet.built_cost = treelet.fitted_cost = fit_nodes(treelet, corners, topology);
  set_corners(treelet, part, corners, topology);
  return treelet;
}

}  // namespace graze::bvh

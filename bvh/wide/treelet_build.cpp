#include <graze/bvh/subtree.h>
#include <graze/bvh/wide/collapse.h>
#include <graze/bvh/wide/fit_node.h>
#include <graze/bvh/wide/treelet_build.h>
#include <graze/bvh/wide/wide_bounds.h>

#include <algorithm>

namespace graze::bvh {
namespace {

void set_lane(WideNode& node, std::uint32_t lane, const FloatBox& box, std::uint32_t link) {
  for (int k = 0; k < 3; ++k) {
    node.centre[k][lane] = 0.5f * (box.min[k] + box.max[k]);
    // Room for the rounding of the centre, and as wide_bounds.h says: local boxes are below 2.
    node.half[k][lane] = rounded_up(0.5 * box.max[k] - 0.5 * box.min[k] + 16 * kFitError);
  }
  node.child[lane] = link;
}

WideNode node_along_coordinates(std::uint32_t count) {
  WideNode node{};
  for (int k = 0; k < 3; ++k)
    node.axes[k][k] = 1;
  node.count = count;
  return node;
}

/// The corners leaf by leaf, with room for reading whole vectors at the end.
std::vector<float> leaf_blocks(std::span<const WideTopologyNode> nodes, const CornerRows& rows) {
  constexpr std::size_t kRoom = 4;
  std::vector<float> blocks(CornerRows::kRows * rows.size() + kRoom);
  for (const WideTopologyNode& node : nodes) {
    for (std::uint32_t j = 0; j < node.count; ++j) {
      if (!ChildLink::is_leaf(node.child[j])) continue;
      const PrimitiveRange range = node.range[j];
      float* block = blocks.data() + CornerRows::kRows * range.begin;
      for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t k = 0; k < 3; ++k)
          block = std::copy(rows.row(c, k) + range.begin, rows.row(c, k) + range.end, block);
      }
    }
  }
  return blocks;
}

/// Puts the primitives in the order of the leaves of the binary tree over them.
std::vector<Node> ordered_nodes(WideTree::Treelet& treelet, std::span<std::uint32_t> order,
                                const LocalFrame& frame, const CornerSource& source) {
  References references = source.references(frame, order);
  const Part part = part_of(references.all(), 0, references.size, treelet.depth);
  const FloatBox box = float_box(part.box);
  for (int k = 0; k < 3; ++k)
    treelet.origin[k] = 0.5 * box.min[k] + 0.5 * box.max[k];
  std::vector<Node> nodes = build_subtree(references.all(), part, kWideSettings);
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = references.data[i].index();
  return nodes;
}

}  // namespace

std::vector<WideNode> top_nodes(const TopTree& top, const FloatBox& box) {
  std::vector<WideNode> nodes{node_along_coordinates(1)};
  if (top.parts.size() == 1) {
    set_lane(nodes[0], 0, box, ChildLink::to_treelet(1));
    return nodes;
  }
  set_lane(nodes[0], 0, box, ChildLink::to_node(1));
  for (const WideTopologyNode& wide : collapse(top.nodes)) {
    WideNode node = node_along_coordinates(wide.count);
    for (std::uint32_t j = 0; j < wide.count; ++j) {
      const Node& binary = top.nodes[wide.node[j]];
      set_lane(node, j, binary.box,
               binary.is_leaf() ? ChildLink::to_treelet(binary.first + 1)
                                : ChildLink::to_node(wide.child[j]));
    }
    nodes.push_back(node);
  }
  return nodes;
}

void build_treelet(WideTree::Treelet& treelet, std::span<std::uint32_t> order,
                   const LocalFrame& frame, const CornerSource& source) {
  const std::vector<Node> binary = ordered_nodes(treelet, order, frame, source);
  CornerRows rows(order.size());
  source.fill(order, frame, treelet.origin, rows);
  treelet.reach = rows.reach();
  const MomentSums sums(rows);
  const std::vector<WideTopologyNode> topology = collapse(binary);
  treelet.nodes.resize(topology.size());
  for (std::size_t i = 0; i < topology.size(); ++i) {
    std::copy_n(topology[i].child, WideNode::kWidth, treelet.nodes[i].child);
    fit_node(rows, sums, {topology[i].range, topology[i].count}, treelet.origin, treelet.nodes[i]);
  }
  treelet.corners = leaf_blocks(topology, rows);
}

}  // namespace graze::bvh

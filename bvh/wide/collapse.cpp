#include <graze/bvh/wide/collapse.h>

#include <algorithm>

namespace graze::bvh {
namespace {

/// Where the primitives below each node begin and end.
std::vector<PrimitiveRange> ranges_of(std::span<const Node> nodes) {
  std::vector<PrimitiveRange> ranges(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const Node& node = nodes[i];
    ranges[i] = node.is_leaf()
                    ? PrimitiveRange{node.first, node.first + node.count}
                    : PrimitiveRange{ranges[node.first].begin, ranges[node.first + 1].end};
  }
  return ranges;
}

/// The binary nodes that become the children of one wide node.
struct Chosen {
  std::uint32_t node[WideNode::kWidth];
  std::uint32_t count = 0;

  void replace_by_children(std::uint32_t index, std::uint32_t first_child) {
    std::copy_backward(node + index + 1, node + count, node + count + 1);
    node[index] = first_child;
    node[index + 1] = first_child + 1;
    ++count;
  }
};

Chosen children_of(std::span<const Node> nodes, std::uint32_t root) {
  Chosen chosen;
  chosen.node[0] = root;
  chosen.count = 1;
  while (chosen.count < WideNode::kWidth) {
    std::uint32_t widest = WideNode::kWidth;
    float surface = -1;
    for (std::uint32_t i = 0; i < chosen.count; ++i) {
      const Node& node = nodes[chosen.node[i]];
      if (node.is_leaf() || !(half_surface(node.box) > surface)) continue;
      widest = i;
      surface = half_surface(node.box);
    }
    if (widest == WideNode::kWidth) break;
    chosen.replace_by_children(widest, nodes[chosen.node[widest]].first);
  }
  return chosen;
}

}  // namespace

std::vector<WideTopologyNode> collapse(std::span<const Node> nodes) {
  const std::vector<PrimitiveRange> ranges = ranges_of(nodes);
  std::vector<WideTopologyNode> wide;
  std::vector<std::uint32_t> roots{0};  // the binary node that wide node i stands for
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const Chosen chosen = children_of(nodes, roots[i]);
    WideTopologyNode node{};
    node.count = chosen.count;
    for (std::uint32_t j = 0; j < chosen.count; ++j) {
      const std::uint32_t child = chosen.node[j];
      node.range[j] = ranges[child];
      if (nodes[child].is_leaf()) {
        node.child[j] = ChildLink::to_leaf(nodes[child].first, nodes[child].count);
      } else {
        node.child[j] = ChildLink::to_node(static_cast<std::uint32_t>(roots.size()));
        roots.push_back(child);
      }
    }
    wide.push_back(node);
  }
  return wide;
}

}  // namespace graze::bvh

#include <graze/bvh/wide/tree/collapse.h>

#include <algorithm>
#include <array>
#include <limits>

namespace graze::bvh {
namespace {

constexpr std::uint32_t kWidth = WideNode::kWidth;

/// The share of the room that a wide node takes in its cost. A wide node costs its surface, for
/// that is how often it is visited, and the room it takes: this many times the surface of
/// everything, shared among the binary nodes. So nodes near the leaves are as large as they can be,
/// and those above stand where they are visited least.
constexpr float kRoomCost = 4;

/// The cheapest ways to hold what lies below a binary node in at most 1, 2, ... 8 roots.
struct Forests {
  std::array<float, kWidth + 1> cost{};          ///< costs by the number of roots, from 1 on
  std::array<std::uint8_t, kWidth + 1> first{};  ///< roots in the first child; 0 if fewer roots do
  std::uint8_t first_below = 0;                  ///< the same where the node becomes a wide one
};

struct Choice {
  float cost = std::numeric_limits<float>::infinity();
  std::uint8_t first = 0;
};

/// Returns the best way to share so many roots among two children.
Choice best_share(const Forests& a, const Forests& b, std::uint32_t roots) {
  Choice best;
  for (std::uint32_t i = 1; i < roots; ++i) {
    const float cost = a.cost[i] + b.cost[roots - i];
    if (cost < best.cost || best.first == 0) best = {cost, static_cast<std::uint8_t>(i)};
  }
  return best;
}

Forests forests_of(const Node& node, const std::vector<Forests>& below, float room) {
  Forests forests;
  if (node.is_leaf()) return forests;  // a lane of whatever holds it
  const Forests& a = below[node.first];
  const Forests& b = below[node.first + 1];
  const Choice children = best_share(a, b, kWidth);
  forests.first_below = children.first;
  forests.cost[1] = children.cost + half_surface(node.box) + room;
  for (std::uint32_t roots = 2; roots <= kWidth; ++roots) {
    const Choice share = best_share(a, b, roots);
    forests.cost[roots] = forests.cost[roots - 1];
    if (share.cost < forests.cost[roots]) {
      forests.cost[roots] = share.cost;
      forests.first[roots] = share.first;
    }
  }
  return forests;
}

class Collapse {
 public:
  explicit Collapse(std::span<const Node> nodes)
      : nodes_(nodes), ranges_(nodes.size()), forests_(nodes.size()) {
    const float room = kRoomCost * half_surface(nodes[0].box) / static_cast<float>(nodes.size());
    for (std::size_t i = nodes.size(); i-- > 0;) {
      const Node& node = nodes[i];
      forests_[i] = forests_of(node, forests_, room);
      ranges_[i] = node.is_leaf()
                       ? PrimitiveRange{node.first, node.first + node.count}
                       : PrimitiveRange{ranges_[node.first].begin, ranges_[node.first + 1].end};
    }
  }

  std::vector<WideTopologyNode> run() {
    std::vector<WideTopologyNode> wide;
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      WideTopologyNode node{};
      add_children(node, roots_[i]);
      for (std::uint32_t j = 0; j < node.count; ++j)
        node.child[j] = link_to(node.node[j], i);
      wide.push_back(node);
    }
    return wide;
  }

 private:
  void add_children(WideTopologyNode& wide, std::uint32_t root) {
    if (nodes_[root].is_leaf()) return add(wide, root);
    const std::uint32_t first = forests_[root].first_below;
    add_roots(wide, nodes_[root].first, first);
    add_roots(wide, nodes_[root].first + 1, kWidth - first);
  }

  /// Adds the roots of the forest of so many that lies below a binary node.
  void add_roots(WideTopologyNode& wide, std::uint32_t at, std::uint32_t roots) {
    while (roots > 1 && forests_[at].first[roots] == 0)
      --roots;
    if (roots == 1) return add(wide, at);
    const std::uint32_t first = forests_[at].first[roots];
    add_roots(wide, nodes_[at].first, first);
    add_roots(wide, nodes_[at].first + 1, roots - first);
  }

  void add(WideTopologyNode& wide, std::uint32_t at) {
    wide.node[wide.count] = at;
    wide.range[wide.count] = ranges_[at];
    ++wide.count;
  }

  std::uint32_t link_to(std::uint32_t at, std::size_t from) {
    const Node& node = nodes_[at];
    if (node.is_leaf()) return ChildLink::to_leaf(node.first, node.count);
    roots_.push_back(at);
    return ChildLink::to_node(static_cast<std::uint32_t>(roots_.size() - 1 - from));
  }

  std::span<const Node> nodes_;
  std::vector<PrimitiveRange> ranges_;
  std::vector<Forests> forests_;
  std::vector<std::uint32_t> roots_{0};  ///< the binary node that wide node i stands for
};

}  // namespace

std::vector<WideTopologyNode> collapse(std::span<const Node> nodes) {
  return Collapse(nodes).run();
}

}  // namespace graze::bvh

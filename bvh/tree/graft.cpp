#include <graze/bvh/tree/graft.h>

namespace graze::bvh {
namespace {

/// Puts the root where its node is, and the others at the end.
void append(std::vector<Node>& nodes, std::size_t at, Graft& graft) {
  const auto first_node = static_cast<std::uint32_t>(nodes.size() - 1);
  for (Node& node : graft.nodes)
    node.first += node.is_leaf() ? graft.first_primitive : first_node;
  nodes[at] = graft.nodes[0];
  nodes.insert(nodes.end(), graft.nodes.begin() + 1, graft.nodes.end());
  std::vector<Node>().swap(graft.nodes);
}

}  // namespace

GraftedNodes grafted(std::span<const Node> stock, std::vector<Graft> grafts) {
  constexpr std::uint32_t kNone = 0xffffffff;
  std::vector<std::uint32_t> graft_at(stock.size(), kNone);
  std::size_t most_nodes = stock.size();
  for (std::size_t i = 0; i < grafts.size(); ++i) {
    graft_at[grafts[i].at] = static_cast<std::uint32_t>(i);
    most_nodes += grafts[i].nodes.size();
  }
  GraftedNodes result;
  std::vector<Node>& nodes = result.nodes;
  nodes.reserve(most_nodes);
  nodes.push_back(stock[0]);
  std::vector<GraftedNodes::Kept> open{{0, 0}};
  while (!open.empty()) {
    const GraftedNodes::Kept node = open.back();
    open.pop_back();
    if (graft_at[node.of_stock] != kNone) {
      append(nodes, node.at, grafts[graft_at[node.of_stock]]);
      continue;
    }
    result.kept.push_back(node);
    if (stock[node.of_stock].is_leaf()) continue;
    const auto at = static_cast<std::uint32_t>(nodes.size());
    const std::uint32_t child = stock[node.of_stock].first;
    nodes[node.at].first = at;
    nodes.push_back(stock[child]);
    nodes.push_back(stock[child + 1]);
    open.push_back({at + 1, child + 1});
    open.push_back({at, child});
  }
  return result;
}

}  // namespace graze::bvh

#include <graze/bvh/wide/tree/fit_slabs.h>
#include <graze/bvh/wide/tree/treelet_fit.h>
#include <graze/bvh/wide/tree/treelet_refit.h>

#include <algorithm>

namespace graze::bvh {
namespace {

/// A treelet may cost so many times what it did: along the axes that it has before others are
/// chosen, and along the best ones before it is built anew.
constexpr float kToleratedTurn = 1.1f;
constexpr float kToleratedDegradation = 1.3f;

/// Returns what collapse() returned when the nodes were built, but for the binary nodes, which are
/// gone. Children stand behind their parents.
std::vector<WideTopologyNode> topology_of(std::span<const WideNode> nodes) {
  std::vector<WideTopologyNode> topology(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    WideTopologyNode& node = topology[i];
    node.count = nodes[i].count;
    std::copy_n(nodes[i].child, WideNode::kWidth, node.child);
    for (std::uint32_t j = 0; j < node.count; ++j) {
      const std::uint32_t link = node.child[j];
      if (ChildLink::is_leaf(link)) {
        const std::uint32_t first = ChildLink::first(link);
        node.range[j] = {first, first + ChildLink::count(link)};
      } else {
        const WideTopologyNode& below = topology[i + ChildLink::index(link)];
        node.range[j] = {below.range[0].begin, below.range[below.count - 1].end};
      }
    }
  }
  return topology;
}

float refit_nodes(Treelet& treelet, const TreeletCorners& corners,
                  std::span<const WideTopologyNode> topology) {
  double surfaces = 0;
  for (std::size_t i = 0; i < topology.size(); ++i) {
    surfaces += refit_node(corners.rows, ranges_of(topology[i]), corners.origin, treelet.nodes[i]);
  }
  choose_slabs(treelet.nodes);
  return cost_of(surfaces, corners);
}

}  // namespace

std::optional<Treelet> refitted_treelet(const Treelet& stock, const TreeletPart& part,
                                        std::span<const std::uint32_t> order,
                                        const LocalFrame& frame, const CornerSource& source) {
  const TreeletCorners corners(part, order, frame, source);
  const std::vector<WideTopologyNode> topology = topology_of(stock.nodes);
  Treelet treelet;
  treelet.nodes = stock.nodes;
  treelet.built_cost = stock.built_cost;
  treelet.fitted_cost = stock.fitted_cost;
  if (refit_nodes(treelet, corners, topology) > kToleratedTurn * stock.fitted_cost) {
    treelet.fitted_cost = fit_nodes(treelet, corners, topology);
    if (treelet.fitted_cost > kToleratedDegradation * stock.built_cost) return std::nullopt;
  }
  set_corners(treelet, part, corners, topology);
  return treelet;
}

}  // namespace graze::bvh

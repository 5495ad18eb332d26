#include <graze/bvh/build/build_nodes.h>
#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/refit/degradation.h>
#include <graze/bvh/refit/degraded_nodes.h>
#include <graze/bvh/refit/refit_references.h>
#include <graze/bvh/tree/graft.h>
#include <graze/bvh/value/parallel.h>

#include <algorithm>
#include <string>
#include <utility>

namespace graze::bvh {
namespace {

/// The primitives below a node, by their places in the tree's order.
struct Range {
  std::uint32_t begin = 0xffffffff;
  std::uint32_t end = 0;
  std::uint32_t count = 0;
};

std::vector<Range> ranges_of(const Tree& tree) {
  std::vector<Range> ranges(tree.nodes.size());
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const Node& node = tree.nodes[i];
    if (node.is_leaf()) {
      ranges[i] = {node.first, node.first + node.count, node.count};
    } else {
      const Range& a = ranges[node.first];
      const Range& b = ranges[node.first + 1];
      ranges[i] = {std::min(a.begin, b.begin), std::max(a.end, b.end), a.count + b.count};
    }
    if (ranges[i].end - ranges[i].begin != ranges[i].count) {
      throw InputError("rebuild: the primitives below node " + std::to_string(i) +
                       " do not lie side by side");
    }
  }
  return ranges;
}

Graft built_anew(Tree& tree, const DegradedNode& degraded, const Range& range,
                 std::span<const Reference> fitted, const BuildSettings& settings) {
  References references(range.count);
  std::copy_n(fitted.begin() + range.begin, range.count, references.data.get());
  return {degraded.node, range.begin,
          build_nodes(std::move(references), degraded.depth, settings,
                      std::span(tree.primitives).subspan(range.begin, range.count))};
}

void check_costs(const Tree& tree, std::span<const float> costs) {
  if (costs.size() == tree.nodes.size()) return;
  throw InputError("rebuild: " + std::to_string(costs.size()) + " costs for " +
                   std::to_string(tree.nodes.size()) + " nodes");
}

}  // namespace

std::vector<float> subtree_costs(const Tree& tree, float primitive_cost) {
  return subtree_costs(std::span<const Node>(tree.nodes), primitive_cost);
}

std::size_t refit_and_rebuild(Tree& tree, std::vector<float>& costs,
                              std::span<const Reference> references, const LocalFrame& frame,
                              const RebuildSettings& settings) {
  refit(tree, references, frame);
  const float primitive_cost = settings.build.primitive_cost;
  const std::vector<float> now = subtree_costs(tree, primitive_cost);
  const std::vector<DegradedNode> degraded =
      find_degraded(tree.nodes, {costs, now, settings.tolerated_degradation});
  if (degraded.empty()) return 0;
  const std::vector<Range> ranges = ranges_of(tree);
  std::vector<Graft> grafts(degraded.size());
  for_in_parallel(std::size_t{0}, degraded.size(), [&](std::size_t i) {
    in_standard_arithmetic([&] {
      grafts[i] =
          built_anew(tree, degraded[i], ranges[degraded[i].node], references, settings.build);
    });
  });
  GraftedNodes renewed = grafted(tree.nodes, std::move(grafts));
  tree.nodes = std::move(renewed.nodes);
  std::vector<float> kept_costs = subtree_costs(tree, primitive_cost);
  for (const GraftedNodes::Kept& node : renewed.kept)
    kept_costs[node.at] = costs[node.of_stock];
  costs = std::move(kept_costs);
  std::size_t primitives = 0;
  for (const DegradedNode& node : degraded)
    primitives += ranges[node.node].count;
  return primitives;
}

std::size_t refit_and_rebuild(Tree& tree, std::vector<float>& costs, std::span<const Aabb> boxes,
                              const RebuildSettings& settings) {
  check_costs(tree, costs);
  ranges_of(tree);  // throws before anything is changed
  FittedReferences fitted = fitted_references(tree, boxes);
  return refit_and_rebuild(tree, costs, fitted.references.all(), fitted.frame, settings);
}

}  // namespace graze::bvh

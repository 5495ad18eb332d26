#include <graze/bvh/build/top_split.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/refit/degraded_nodes.h>
#include <graze/bvh/tree/graft.h>
#include <graze/bvh/tree/node_lanes.h>
#include <graze/bvh/value/parallel.h>
#include <graze/bvh/wide/tree/wide_top.h>

#include <algorithm>
#include <utility>

namespace graze::bvh {
namespace {

/// The largest number of primitives of a treelet: a walk builds these at once, in a fraction of a
/// millisecond.
constexpr std::size_t kTreeletSize = 2048;

/// A part of the top may cost so many times what it did before it is split anew: more than a
/// treelet, because all treelets below are lost with it.
constexpr float kToleratedDegradation = 1.65f;

using Places = std::span<std::uint32_t>;

/// Splits the primitives that the order names, and appends the parts, whose places count from
/// `first`.
std::vector<Node> split_into(std::vector<TreeletPart>& parts, References references, Places order,
                             std::uint32_t first, int depth) {
  TopTree top = split_top(references.all(), kTreeletSize, kWideSettings, depth);
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = references.data[i].index();
  for (const Part& part : top.parts) {
    parts.push_back({first + static_cast<std::uint32_t>(part.begin),
                     static_cast<std::uint32_t>(part.size()), part.depth, float_box(part.box)});
  }
  return std::move(top.nodes);
}

/// Sets the box of each part to where its primitives are now.
void fit_parts(WideTop& top, const CornerSource& source, const LocalFrame& frame, Places order) {
  for_in_parallel(std::size_t{0}, top.parts.size(), [&](std::size_t i) {
    in_standard_arithmetic([&] {
      TreeletPart& part = top.parts[i];
      part.box = float_box(source.bounds(frame, order.subspan(part.first, part.count)));
    });
  });
}

/// Fits all nodes to the boxes of the parts. Children stand behind their parents.
void fit_nodes(WideTop& top) {
  for (std::size_t i = top.nodes.size(); i-- > 0;) {
    Node& node = top.nodes[i];
    if (node.is_leaf()) {
      node.box = top.parts[node.first].box;
    } else {
      node = node_around(top.nodes[node.first], top.nodes[node.first + 1], node.first);
    }
  }
}

/// Returns the places below a node, which lie side by side.
TreeletPart places_below(const WideTop& top, std::uint32_t node) {
  const Node& at = top.nodes[node];
  if (at.is_leaf()) return top.parts[at.first];
  const TreeletPart a = places_below(top, at.first);
  const TreeletPart b = places_below(top, at.first + 1);
  return {std::min(a.first, b.first), a.count + b.count, 0, {}};
}

/// Splits anew what lies below these nodes. Parts that are left over stay, named by no leaf.
void rebuild(WideTop& top, std::span<const DegradedNode> degraded, const CornerSource& source,
             const LocalFrame& frame, Places order) {
  std::vector<Graft> grafts;
  for (const DegradedNode& node : degraded) {
    const TreeletPart below = places_below(top, node.node);
    const Places places = order.subspan(below.first, below.count);
    // The primitives are taken in their own order, so that nothing but their positions says what is
    // built.
    References references =
        below.count == order.size() ? source.references(frame) : source.references(frame, places);
    const auto first_part = static_cast<std::uint32_t>(top.parts.size());
    grafts.push_back(
        {node.node, first_part,
         split_into(top.parts, std::move(references), places, below.first, node.depth)});
  }
  top.inherited.resize(top.parts.size());
  GraftedNodes renewed = grafted(top.nodes, std::move(grafts));
  top.nodes = std::move(renewed.nodes);
  std::vector<float> costs = subtree_costs(top.nodes, kWideSettings.primitive_cost);
  for (const GraftedNodes::Kept& node : renewed.kept)
    costs[node.at] = top.costs[node.of_stock];
  top.costs = std::move(costs);
}

/// Drops the parts that no leaf names.
void number_parts(WideTop& top) {
  std::vector<TreeletPart> parts;
  std::vector<std::shared_ptr<const Treelet>> inherited;
  for (Node& node : top.nodes) {
    if (!node.is_leaf()) continue;
    parts.push_back(top.parts[node.first]);
    inherited.push_back(std::move(top.inherited[node.first]));
    node.first = static_cast<std::uint32_t>(parts.size() - 1);
  }
  top.parts = std::move(parts);
  top.inherited = std::move(inherited);
}

}  // namespace

WideTop split_all(const CornerSource& source, const LocalFrame& frame,
                  std::vector<std::uint32_t>& order) {
  WideTop top;
  order.resize(source.size());
  top.nodes = split_into(top.parts, source.references(frame), order, 0, 0);
  top.costs = subtree_costs(top.nodes, kWideSettings.primitive_cost);
  top.inherited.resize(top.parts.size());
  return top;
}

WideTop refitted(WideTop stock, const CornerSource& source, const LocalFrame& frame,
                 std::vector<std::uint32_t>& order) {
  WideTop top = std::move(stock);
  fit_parts(top, source, frame, order);
  fit_nodes(top);
  const std::vector<float> now = subtree_costs(top.nodes, kWideSettings.primitive_cost);
  const std::vector<DegradedNode> degraded =
      find_degraded(top.nodes, {top.costs, now, kToleratedDegradation});
  if (degraded.empty()) return top;
  rebuild(top, degraded, source, frame, order);
  number_parts(top);
  return top;
}

}  // namespace graze::bvh

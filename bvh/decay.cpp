#include <graze/bvh/build_nodes.h>
#include <graze/bvh/decay.h>
#include <graze/bvh/error.h>
#include <graze/bvh/graft.h>
#include <graze/bvh/refit.h>
#include <graze/bvh/sah_sweep.h>
#include <graze/bvh/to_local.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <string>
#include <utility>

namespace graze::bvh {
namespace {

float length(const FloatBox& box) {
  return (box.max[0] - box.min[0]) + (box.max[1] - box.min[1]) + (box.max[2] - box.min[2]);
}

/// How likely a line through the outer box meets the inner one.
float share_of(const FloatBox& inner, const FloatBox& outer) {
  const float surface = half_surface(outer);
  if (surface > kSmallestSurface) return half_surface(inner) / surface;
  return length(outer) > 0 ? length(inner) / length(outer) : 1;
}

/// Of an inner node with children that cost this much.
template <typename CostOf>
float inner_cost(const Tree& tree, const Node& node, const CostOf& cost_of) {
  const std::size_t a = node.first;
  const std::size_t b = a + 1;
  return 1 + (share_of(tree.nodes[a].box, node.box) * cost_of(a) +
              share_of(tree.nodes[b].box, node.box) * cost_of(b));
}

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

/// A node to be built anew.
struct Decayed {
  std::uint32_t node;
  int depth;
};

/// What each node cost when it was built, costs now, and by how much it may have grown.
struct Growth {
  std::span<const float> then;
  std::span<const float> now;
  float tolerated;

  bool is_decayed(std::size_t node) const { return now[node] > tolerated * then[node]; }
};

/// Whether a node is itself to blame: its boxes have grown into each other, which shows if its
/// children are thought as good as new, or nothing below has decayed as a whole. The former needs
/// no more than a quarter of the growth that is tolerated, because it adds up over the levels.
bool is_to_blame(const Tree& tree, const Node& node, const Growth& growth) {
  const auto repaired_cost = [&](std::size_t child) {
    return std::min(growth.then[child], growth.now[child]);
  };
  const auto at = static_cast<std::size_t>(&node - tree.nodes.data());
  return inner_cost(tree, node, repaired_cost) >
             (0.75f + 0.25f * growth.tolerated) * growth.then[at] ||
         !(growth.is_decayed(node.first) || growth.is_decayed(node.first + 1));
}

/// The uppermost of the decayed nodes that are to blame.
std::vector<Decayed> find_decayed(const Tree& tree, const Growth& growth) {
  std::vector<Decayed> found;
  std::vector<Decayed> open{{0, 0}};
  while (!open.empty()) {
    const Decayed at = open.back();
    open.pop_back();
    const Node& node = tree.nodes[at.node];
    if (node.is_leaf()) continue;
    if (growth.is_decayed(at.node) && is_to_blame(tree, node, growth)) {
      found.push_back(at);
      continue;
    }
    open.push_back({node.first + 1, at.depth + 1});
    open.push_back({node.first, at.depth + 1});
  }
  return found;
}

Graft built_anew(Tree& tree, const Decayed& decayed, const Range& range,
                 std::span<const Aabb> boxes, const BuildSettings& settings) {
  const std::span<std::uint32_t> primitives =
      std::span(tree.primitives).subspan(range.begin, range.count);
  const ToLocal to_local(tree.frame);
  References references(range.count);
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const Aabb& box = boxes[primitives[i]];
    references.data[i] = reference_to(to_local.box(box.min.data(), box.max.data()), primitives[i]);
  }
  return {decayed.node, range.begin,
          build_nodes(std::move(references), decayed.depth, settings, primitives)};
}

}  // namespace

std::vector<float> subtree_costs(const Tree& tree, float primitive_cost) {
  std::vector<float> costs(tree.nodes.size());
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const Node& node = tree.nodes[i];
    costs[i] = node.is_leaf()
                   ? primitive_cost * static_cast<float>(node.count)
                   : inner_cost(tree, node, [&](std::size_t child) { return costs[child]; });
  }
  return costs;
}

std::size_t refit_and_rebuild(Tree& tree, std::vector<float>& costs, std::span<const Aabb> boxes,
                              const RebuildSettings& settings) {
  if (costs.size() != tree.nodes.size()) {
    throw InputError("rebuild: " + std::to_string(costs.size()) + " costs for " +
                     std::to_string(tree.nodes.size()) + " nodes");
  }
  const std::vector<Range> ranges = ranges_of(tree);
  refit(tree, boxes);
  const float primitive_cost = settings.build.primitive_cost;
  const std::vector<float> now = subtree_costs(tree, primitive_cost);
  const std::vector<Decayed> decayed = find_decayed(tree, {costs, now, settings.tolerated_decay});
  if (decayed.empty()) return 0;
  std::vector<Graft> grafts(decayed.size());
  tbb::parallel_for(std::size_t{0}, decayed.size(), [&](std::size_t i) {
    grafts[i] = built_anew(tree, decayed[i], ranges[decayed[i].node], boxes, settings.build);
  });
  GraftedNodes renewed = grafted(tree.nodes, std::move(grafts));
  tree.nodes = std::move(renewed.nodes);
  std::vector<float> kept_costs = subtree_costs(tree, primitive_cost);
  for (const GraftedNodes::Kept& node : renewed.kept)
    kept_costs[node.at] = costs[node.of_stock];
  costs = std::move(kept_costs);
  std::size_t primitives = 0;
  for (const Decayed& node : decayed)
    primitives += ranges[node.node].count;
  return primitives;
}

}  // namespace graze::bvh

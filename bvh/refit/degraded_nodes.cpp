#include <graze/bvh/build/sah_sweep.h>
#include <graze/bvh/refit/degraded_nodes.h>

#include <algorithm>

namespace graze::bvh {
namespace {

float length(const FloatBox& box) {
  return (box.max[0] - box.min[0]) + (box.max[1] - box.min[1]) + (box.max[2] - box.min[2]);
}

/// Returns the cost of an inner node with children that cost this much. How likely a line through
/// its box meets a child's is the ratio of their surfaces or, of boxes without any, their lengths.
template <typename CostOf>
float inner_cost(std::span<const Node> nodes, const Node& node, const CostOf& cost_of) {
  const std::size_t a = node.first;
  const std::size_t b = a + 1;
  const FloatBox& box_a = nodes[a].box;
  const FloatBox& box_b = nodes[b].box;
  const float surface = half_surface(node.box);
  if (surface > kSmallestSurface)
    return 1 + (half_surface(box_a) * cost_of(a) + half_surface(box_b) * cost_of(b)) / surface;
  const float all = length(node.box);
  if (all > 0) return 1 + (length(box_a) * cost_of(a) + length(box_b) * cost_of(b)) / all;
  return 1 + (cost_of(a) + cost_of(b));
}

bool has_degraded(std::span<const Node> nodes, const Growth& growth) {
  bool is_any = false;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    is_any |= growth.is_degraded(i);
  return is_any;
}

/// True if a node is itself to blame: its boxes have grown into each other, which shows if its
/// children are thought as good as new, or nothing below has degraded as a whole. The former needs
/// no more than a quarter of the growth that is tolerated, because it adds up over the levels.
bool is_to_blame(std::span<const Node> nodes, const Node& node, const Growth& growth) {
  const auto repaired_cost = [&](std::size_t child) {
    return std::min(growth.then[child], growth.now[child]);
  };
  const auto at = static_cast<std::size_t>(&node - nodes.data());
  return inner_cost(nodes, node, repaired_cost) >
             (0.75f + 0.25f * growth.tolerated) * growth.then[at] ||
         !(growth.is_degraded(node.first) || growth.is_degraded(node.first + 1));
}

}  // namespace

std::vector<float> subtree_costs(std::span<const Node> nodes, float primitive_cost) {
  std::vector<float> costs(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const Node& node = nodes[i];
    costs[i] = node.is_leaf()
                   ? primitive_cost * static_cast<float>(node.count)
                   : inner_cost(nodes, node, [&](std::size_t child) { return costs[child]; });
  }
  return costs;
}

std::vector<DegradedNode> find_degraded(std::span<const Node> nodes, const Growth& growth) {
  std::vector<DegradedNode> found;
  if (!has_degraded(nodes, growth)) return found;
  std::vector<DegradedNode> open{{0, 0}};
  while (!open.empty()) {
    const DegradedNode at = open.back();
    open.pop_back();
    const Node& node = nodes[at.node];
    if (node.is_leaf()) continue;
    if (growth.is_degraded(at.node) && is_to_blame(nodes, node, growth)) {
      found.push_back(at);
      continue;
    }
    open.push_back({node.first + 1, at.depth + 1});
    open.push_back({node.first, at.depth + 1});
  }
  return found;
}

}  // namespace graze::bvh

#include <graze/bvh/rays/ray_groups.h>

#include <algorithm>
#include <limits>

namespace graze::bvh {
namespace {

/// The cost of a node beside its surface, so that there are fewer nodes where that makes no
/// difference to rays, and more leaves can share points. It is a share of a primitive in the
/// surface of the box of all.
constexpr float kRoom = 16;

}  // namespace

// A node's children are behind it, the first one's places before the second one's.
RayGroups::RayGroups(const Tree& tree, std::uint32_t leaf_size)
    : tree_(tree), leaf_size_(leaf_size), below_(tree.nodes.size()), costs_(tree.nodes.size()) {
  const float room =
      kRoom * half_surface(tree.root().box) / static_cast<float>(tree.primitives.size());
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const Node& node = tree.nodes[i];
    if (node.is_leaf()) {
      below_[i] = {node.first, node.count};
    } else {
      const Places a = below_[node.first], b = below_[node.first + 1];
      below_[i] = {std::min(a.first, b.first), a.count + b.count};
    }
    // A leaf is compared as fast as a node.
    const auto binary = static_cast<std::uint32_t>(i);
    const float surface = half_surface(node.box);
    if (is_leaf(binary)) {
      costs_[i].fill(surface);
      continue;
    }
    costs_[i][0] = surface + room + best_cut(binary, kWidth).cost;
    for (std::uint32_t parts = 2; parts <= kWidth; ++parts)
      costs_[i][parts - 1] = std::min(costs_[i][parts - 2], best_cut(binary, parts).cost);
  }
}

RayGroups::Cut RayGroups::best_cut(std::uint32_t binary, std::uint32_t parts) const {
  const auto& a = costs_[tree_.nodes[binary].first];
  const auto& b = costs_[tree_.nodes[binary].first + 1];
  Cut best{std::numeric_limits<float>::infinity(), 1};
  for (std::uint32_t k = 1; k < parts; ++k) {
    const float cost = a[k - 1] + b[parts - k - 1];
    if (cost < best.cost) best = {cost, k};
  }
  return best;
}

std::uint32_t RayGroups::children(std::uint32_t binary, std::uint32_t (&found)[kWidth]) const {
  std::uint32_t count = 0;
  if (is_leaf(binary)) {
    found[count++] = binary;
    return count;
  }
  const std::uint32_t for_first = best_cut(binary, kWidth).for_first;
  collect(tree_.nodes[binary].first, for_first, found, count);
  collect(tree_.nodes[binary].first + 1, kWidth - for_first, found, count);
  return count;
}

void RayGroups::collect(std::uint32_t binary, std::uint32_t parts, std::uint32_t (&found)[kWidth],
                        std::uint32_t& count) const {
  while (parts > 1 && costs_[binary][parts - 1] == costs_[binary][parts - 2])
    --parts;
  if (parts == 1) {
    found[count++] = binary;
    return;
  }
  const std::uint32_t for_first = best_cut(binary, parts).for_first;
  collect(tree_.nodes[binary].first, for_first, found, count);
  collect(tree_.nodes[binary].first + 1, parts - for_first, found, count);
}

}  // namespace graze::bvh

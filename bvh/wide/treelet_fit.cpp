#include <graze/bvh/wide/treelet_fit.h>

#include <algorithm>

namespace graze::bvh {
namespace {

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

}  // namespace

TreeletCorners::TreeletCorners(const TreeletPart& part, std::span<const std::uint32_t> order,
                               const LocalFrame& frame, const CornerSource& source)
    : rows(order.size()) {
  for (int k = 0; k < 3; ++k)
    origin[k] = 0.5 * part.box.min[k] + 0.5 * part.box.max[k];
  source.fill(order, frame, origin, rows);
}

void set_corners(Treelet& treelet, const TreeletPart& part, const TreeletCorners& corners,
                 std::span<const WideTopologyNode> topology) {
  std::copy_n(corners.origin, 3, treelet.origin);
  treelet.first = part.first;
  treelet.reach = corners.rows.reach();
  treelet.corners = leaf_blocks(topology, corners.rows);
}

float fit_nodes(Treelet& treelet, const TreeletCorners& corners,
                std::span<const WideTopologyNode> topology) {
  const MomentSums sums(corners.rows);
  TreeletCost cost;
  for (std::size_t i = 0; i < topology.size(); ++i) {
    cost.add(
        fit_node(corners.rows, sums, ranges_of(topology[i]), corners.origin, treelet.nodes[i]));
  }
  return cost.value();
}

}  // namespace graze::bvh

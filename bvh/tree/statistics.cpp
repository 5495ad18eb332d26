#include <graze/bvh/tree/statistics.h>

#include <algorithm>
#include <vector>

namespace graze::bvh {

TreeStatistics statistics_of(const Tree& tree) {
  TreeStatistics statistics;
  statistics.node_count = tree.nodes.size();
  statistics.bytes =
      tree.nodes.size() * sizeof(Node) + tree.primitives.size() * sizeof(std::uint32_t);
  const double root_surface = half_surface(tree.root().box);
  std::vector<std::size_t> depth(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const Node& node = tree.nodes[i];
    const double share = root_surface > 0 ? half_surface(node.box) / root_surface : 1;
    statistics.expected_node_visits += share;
    if (!node.is_leaf()) {
      depth[node.first] = depth[node.first + 1] = depth[i] + 1;
      continue;
    }
    ++statistics.leaf_count;
    statistics.expected_primitive_tests += share * node.count;
    statistics.largest_leaf = std::max<std::size_t>(statistics.largest_leaf, node.count);
    statistics.depth = std::max(statistics.depth, depth[i]);
  }
  statistics.mean_leaf_size =
      static_cast<double>(tree.primitives.size()) / static_cast<double>(statistics.leaf_count);
  return statistics;
}

}  // namespace graze::bvh

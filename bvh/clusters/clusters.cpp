#include <graze/bvh/clusters/clusters.h>

namespace graze::bvh {

std::vector<std::uint32_t> counts_below(const Tree& tree) {
  std::vector<std::uint32_t> counts(tree.nodes.size());
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {  // children stand behind their parents
    const Node& node = tree.nodes[i];
    counts[i] = node.is_leaf() ? node.count : counts[node.first] + counts[node.first + 1];
  }
  return counts;
}

std::size_t cluster_count(const Tree& tree, const std::vector<std::uint32_t>& counts) {
  std::size_t clusters = counts[0] <= Cluster::kWidth ? 1 : 0;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const std::uint32_t first = tree.nodes[i].first;
    if (counts[i] > Cluster::kWidth)
      clusters += (counts[first] <= Cluster::kWidth) + (counts[first + 1] <= Cluster::kWidth);
  }
  return clusters;
}

void make_empty(Cluster& cluster) {
  const FloatBox empty = empty_box();
  for (std::uint32_t lane = 0; lane < Cluster::kWidth; ++lane)
    set_lane(cluster, lane, 0, empty, {0, 0, 0});
  cluster.count = 0;
}

void set_lane(Cluster& cluster, std::uint32_t lane, std::uint32_t primitive, const FloatBox& box,
              const std::uint32_t (&labels)[3]) {
  for (int k = 0; k < 3; ++k) {
    cluster.box[2 * k][lane] = box.min[k];
    cluster.box[2 * k + 1][lane] = box.max[k];
    cluster.label[k][lane] = labels[k];
  }
  cluster.primitive[lane] = primitive;
}

}  // namespace graze::bvh

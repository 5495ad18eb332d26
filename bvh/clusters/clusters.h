#pragma once

#include <graze/bvh/tree/tree.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace graze::bvh {

/// Up to eight primitives below one node of a tree. Lane j of each row speaks of primitive j, whose
/// box reaches from box[2 k][j] to box[2 k + 1][j] along axis k. Boxes of empty lanes are empty.
struct alignas(32) Cluster {
  static constexpr std::uint32_t kWidth = 8;

  float box[6][kWidth];
  std::uint32_t label[3][kWidth];
  std::uint32_t primitive[kWidth];
  std::uint32_t count;
};

/// A tree's nodes, cut where a cluster holds all that is below.
struct Clusters {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  std::vector<Cluster> all;            ///< the clusters in the order of the leaves
  std::vector<std::uint32_t> of_node;  ///< the cluster of each node; kNone above and below the cut

  bool is_cluster(std::uint32_t node) const { return of_node[node] != kNone; }
};

/// Returns how many primitives are below each node, in linear time.
std::vector<std::uint32_t> counts_below(const Tree& tree);

/// Returns how many clusters there will be, in linear time.
std::size_t cluster_count(const Tree& tree, const std::vector<std::uint32_t>& counts);

/// Puts a primitive into lane `lane`, which must be the next one.
void set_lane(Cluster& cluster, std::uint32_t lane, std::uint32_t primitive, const FloatBox& box,
              const std::uint32_t (&labels)[3]);

/// Takes all primitives out.
void make_empty(Cluster& cluster);

/// Cuts a tree whose leaves hold no more than a cluster does. `box_of(place)` says the box in the
/// tree's frame of the primitive at a place in the order of the leaves, `set_labels(place, labels)`
/// its three labels. It takes linear time.
template <typename BoxOf, typename SetLabels>
Clusters clusters_of(const Tree& tree, BoxOf&& box_of, SetLabels&& set_labels) {
  Clusters clusters;
  clusters.of_node = counts_below(tree);
  clusters.all.reserve(cluster_count(tree, clusters.of_node));
  const auto add_leaf = [&](Cluster& cluster, const Node& leaf) {
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      std::uint32_t labels[3];
      set_labels(i, labels);
      set_lane(cluster, cluster.count++, tree.primitives[i], leaf.count == 1 ? leaf.box : box_of(i),
               labels);
    }
  };
  std::vector<std::uint32_t> open = {0}, below;
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    open.pop_back();
    std::uint32_t& of_node = clusters.of_node[index];
    if (of_node > Cluster::kWidth) {
      of_node = Clusters::kNone;
      open.push_back(tree.nodes[index].first + 1);
      open.push_back(tree.nodes[index].first);
      continue;
    }
    of_node = static_cast<std::uint32_t>(clusters.all.size());
    Cluster& cluster = clusters.all.emplace_back();
    make_empty(cluster);
    below.push_back(index);
    while (!below.empty()) {
      const Node& node = tree.nodes[below.back()];
      below.pop_back();
      if (node.is_leaf()) {
        add_leaf(cluster, node);
      } else {
        below.push_back(node.first + 1);
        below.push_back(node.first);
      }
    }
  }
  return clusters;
}

}  // namespace graze::bvh

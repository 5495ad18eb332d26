#include <graze/bvh/build/build.h>
#include <graze/bvh/clusters/cluster_pairs.h>
#include <graze/bvh/skins/node_separation.h>
#include <graze/bvh/traverse/traverse_self.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <set>
#include <utility>
#include <vector>

#include "tests/bvh/random_boxes.h"
#include "tests/narrowphase/simd_targets.h"
#include "tests/shapes/random_source.h"

namespace graze::bvh {
namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// Boxes in the frame of a tree over them, each with three labels of a few.
struct Labelled {
  std::vector<Aabb> boxes;
  std::vector<std::array<std::uint32_t, 3>> labels;
  Tree tree;
  std::vector<FloatBox> local;

  Labelled(Distribution distribution, std::size_t count)
      : boxes(random_boxes(distribution, count, 3)), tree(build(boxes)) {
    RandomSource source(5);
    for (const Aabb& box : boxes) {
      local.push_back(tree.frame.to_local(box));
      auto& own = labels.emplace_back();
      for (std::uint32_t& label : own)
        label = static_cast<std::uint32_t>(source.integer(0, 99));
    }
  }

  Clusters clusters() const {
    return clusters_of(
        tree, [&](std::uint32_t place) { return local[tree.primitives[place]]; },
        [&](std::uint32_t place, std::uint32_t(&own)[3]) {
          std::copy_n(labels[tree.primitives[place]].data(), 3, own);
        });
  }

  bool are_sharing(std::uint32_t i, std::uint32_t j) const {
    return std::find_first_of(labels[i].begin(), labels[i].end(), labels[j].begin(),
                              labels[j].end()) != labels[i].end();
  }
};

class ClustersOn : public testing::TestWithParam<Distribution> {};

INSTANTIATE_TEST_SUITE_P(Distributions, ClustersOn, testing::ValuesIn(kDistributions),
                         testing::PrintToStringParamName());

TEST_P(ClustersOn, HoldEachPrimitiveOnce) {
  for (const std::size_t count : {1u, 5u, 8u, 9u, 700u}) {
    const Labelled labelled(GetParam(), count);
    const Clusters clusters = labelled.clusters();
    EXPECT_EQ(clusters.all.size(), clusters.all.capacity()) << "were counted first";
    std::vector<int> times(count);
    for (const Cluster& cluster : clusters.all) {
      ASSERT_LE(cluster.count, Cluster::kWidth);
      ASSERT_GT(cluster.count, 0u);
      for (std::uint32_t lane = 0; lane < cluster.count; ++lane) {
        const std::uint32_t primitive = cluster.primitive[lane];
        ++times[primitive];
        for (int k = 0; k < 3; ++k) {
          EXPECT_LE(cluster.box[2 * k][lane], labelled.local[primitive].min[k]);
          EXPECT_GE(cluster.box[2 * k + 1][lane], labelled.local[primitive].max[k]);
          EXPECT_EQ(cluster.label[k][lane], labelled.labels[primitive][k]);
        }
      }
    }
    EXPECT_EQ(times, std::vector<int>(count, 1));
  }
}

TEST_P(ClustersOn, PairsAreBruteForceOnEverySimdTarget) {
  const Labelled labelled(GetParam(), 300);
  Pairs overlapping, sharing;
  for (std::uint32_t i = 0; i < labelled.boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < labelled.boxes.size(); ++j) {
      if (!overlap(labelled.local[i], labelled.local[j])) continue;
      overlapping.insert({i, j});
      if (labelled.are_sharing(i, j)) sharing.insert({i, j});
    }
  }
  const Clusters clusters = labelled.clusters();
  const Tree& tree = labelled.tree;
  for (const std::int64_t target : narrowphase::simd_targets()) {
    narrowphase::force_simd_target(target);
    Pairs found_overlapping, found_sharing;
    const auto add = [](Pairs& pairs, std::uint64_t bits, const Cluster& a, const Cluster& b) {
      for (; bits != 0; bits &= bits - 1) {
        const int i = std::countr_zero(bits) / 8, j = std::countr_zero(bits) % 8;
        ASSERT_LT(static_cast<std::uint32_t>(i), a.count);
        ASSERT_LT(static_cast<std::uint32_t>(j), b.count);
        EXPECT_TRUE(pairs.insert(std::minmax(a.primitive[i], b.primitive[j])).second)
            << "each pair once";
      }
    };
    traverse_self(
        tree, NodeOverlap(tree.nodes, tree.nodes),
        [&](std::uint32_t node) { return clusters.is_cluster(node); },
        [&](std::uint32_t node_a, std::uint32_t node_b) {
          const Cluster& a = clusters.all[clusters.of_node[node_a]];
          const Cluster& b = clusters.all[clusters.of_node[node_b]];
          const ClusterPairs pairs = node_a == node_b ? pairs_within(a) : pairs_of(a, b);
          add(found_overlapping, pairs.overlapping, a, b);
          add(found_sharing, pairs.sharing, a, b);
          return Walk::Continue;
        });
    EXPECT_EQ(found_overlapping, overlapping) << target;
    EXPECT_EQ(found_sharing, sharing) << target;
  }
  narrowphase::force_simd_target(0);
  EXPECT_FALSE(sharing.empty() && overlapping.size() > 200);
}

}  // namespace
}  // namespace graze::bvh

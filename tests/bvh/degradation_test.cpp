#include <graze/bvh/build/build.h>
#include <graze/bvh/error.h>
#include <graze/bvh/refit/degradation.h>
#include <graze/bvh/refit/refit.h>
#include <graze/bvh/tree/validate.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>
#include <utility>
#include <vector>

#include "tests/bvh/random_boxes.h"

namespace graze::bvh {
namespace {

constexpr float kPrimitiveCost = BuildSettings{}.primitive_cost;

bool is_same(const Tree& a, const Tree& b) {
  return a.primitives == b.primitives && a.nodes.size() == b.nodes.size() &&
         std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(Node)) == 0;
}

/// Those in a corner of the cube trade places in pairs, each with one that is far in the list.
std::vector<Aabb> with_a_scrambled_corner(std::vector<Aabb> boxes) {
  std::vector<std::size_t> corner;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].max.maxCoeff() < -0.2) corner.push_back(i);
  }
  for (std::size_t i = 0; i + 1 < corner.size() / 2; ++i)
    std::swap(boxes[corner[i]], boxes[corner[corner.size() - 1 - i]]);
  return boxes;
}

TEST(Degradation, CostsOfAKnownTree) {
  Tree tree;
  tree.frame = LocalFrame::around({Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()});
  tree.nodes = {{{{0, 0, 0}, {2, 1, 1}}, 1, 0},
                {{{0, 0, 0}, {1, 1, 1}}, 0, 2},
                {{{1, 0, 0}, {2, 1, 1}}, 2, 1}};
  tree.primitives = {0, 1, 2};
  const std::vector<float> costs = subtree_costs(tree, 1.5f);
  ASSERT_EQ(costs.size(), 3u);
  EXPECT_FLOAT_EQ(costs[0], 1 + 0.6f * 3 + 0.6f * 1.5f);
  EXPECT_FLOAT_EQ(costs[1], 3);
  EXPECT_FLOAT_EQ(costs[2], 1.5f);
}

TEST(Degradation, NothingIsBuiltWhereNothingDegrades) {
  std::vector<Aabb> boxes = random_boxes(Distribution::Uniform, 3000, 1);
  Tree tree = build(boxes);
  const Tree before = tree;
  std::vector<float> costs = subtree_costs(tree, kPrimitiveCost);
  EXPECT_EQ(refit_and_rebuild(tree, costs, boxes), 0u);
  EXPECT_TRUE(is_same(tree, before));
  for (Aabb& box : boxes) {  // twice as large, and elsewhere
    box.min = 2 * box.min + Eigen::Vector3d(1, 2, 3);
    box.max = 2 * box.max + Eigen::Vector3d(1, 2, 3);
  }
  EXPECT_EQ(refit_and_rebuild(tree, costs, boxes), 0u);
  EXPECT_EQ(tree.primitives, before.primitives);
}

TEST(Degradation, RepairsACornerWhereItIs) {
  const std::vector<Aabb> before = random_boxes(Distribution::Uniform, 20000, 2);
  const std::vector<Aabb> after = with_a_scrambled_corner(before);
  Tree tree = build(before);
  std::vector<float> costs = subtree_costs(tree, kPrimitiveCost);
  Tree only_refit = tree;
  refit(only_refit, after);
  const double fresh = subtree_costs(build(after), kPrimitiveCost)[0];
  ASSERT_GT(subtree_costs(only_refit, kPrimitiveCost)[0], 1.1 * fresh);
  const std::size_t rebuilt = refit_and_rebuild(tree, costs, after);
  EXPECT_EQ(find_broken_invariant(tree, after).value_or(""), "");
  EXPECT_GT(rebuilt, 500u);
  EXPECT_LT(rebuilt, 7000u);
  EXPECT_LT(subtree_costs(tree, kPrimitiveCost)[0], 1.05 * fresh);
  EXPECT_EQ(costs.size(), tree.nodes.size());
  EXPECT_EQ(refit_and_rebuild(tree, costs, after), 0u);
}

TEST(Degradation, AScrambleOfAllIsBuiltAnew) {
  const std::vector<Aabb> after = random_boxes(Distribution::Uniform, 5000, 4);
  Tree tree = build(random_boxes(Distribution::Uniform, 5000, 3));
  std::vector<float> costs = subtree_costs(tree, kPrimitiveCost);
  EXPECT_EQ(refit_and_rebuild(tree, costs, after), 5000u);
  EXPECT_EQ(find_broken_invariant(tree, after).value_or(""), "");
  EXPECT_LT(subtree_costs(tree, kPrimitiveCost)[0],
            1.01 * subtree_costs(build(after), kPrimitiveCost)[0]);
  EXPECT_EQ(costs, subtree_costs(tree, kPrimitiveCost));
}

TEST(Degradation, AnyMotionKeepsTheInvariants) {
  Tree tree = build(random_boxes(Distribution::Grid, 2000, 1));
  std::vector<float> costs = subtree_costs(tree, kPrimitiveCost);
  for (float tolerated : {1.01f, 1.5f, 4.f}) {
    for (Distribution distribution : kDistributions) {
      const std::vector<Aabb> boxes = random_boxes(distribution, 2000, 9);
      refit_and_rebuild(tree, costs, boxes, {.build = {}, .tolerated_degradation = tolerated});
      ASSERT_EQ(find_broken_invariant(tree, boxes).value_or(""), "");
      ASSERT_EQ(costs.size(), tree.nodes.size());
    }
  }
}

TEST(Degradation, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Aabb> before = random_boxes(Distribution::Uniform, 20000, 5);
  const std::vector<Aabb> after = with_a_scrambled_corner(before);
  const auto repaired_on = [&](std::size_t threads) {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Tree tree = build(before);
    std::vector<float> costs = subtree_costs(tree, kPrimitiveCost);
    refit_and_rebuild(tree, costs, after);
    return tree;
  };
  EXPECT_TRUE(is_same(repaired_on(1), repaired_on(3)));
}

TEST(Degradation, RefusesWhatItCannotRepair) {
  const std::vector<Aabb> boxes = random_boxes(Distribution::Uniform, 50, 1);
  Tree tree = build(boxes);
  const Tree before = tree;
  std::vector<float> costs = subtree_costs(tree, kPrimitiveCost);
  std::vector<float> fewer(costs.begin(), costs.end() - 1);
  EXPECT_THROW(refit_and_rebuild(tree, fewer, boxes), InputError);
  EXPECT_THROW(refit_and_rebuild(tree, costs, random_boxes(Distribution::Uniform, 49, 1)),
               InputError);
  EXPECT_TRUE(is_same(tree, before));
  Tree mixed = build(random_boxes(Distribution::Uniform, 4, 1), {.max_leaf_size = 1});
  std::vector<std::size_t> leaves;
  for (std::size_t i = 0; i < mixed.nodes.size(); ++i) {
    if (mixed.nodes[i].is_leaf()) leaves.push_back(i);
  }
  std::swap(mixed.nodes[leaves.front()].first, mixed.nodes[leaves.back()].first);
  std::vector<float> of_mixed = subtree_costs(mixed, kPrimitiveCost);
  EXPECT_THROW(refit_and_rebuild(mixed, of_mixed, random_boxes(Distribution::Uniform, 4, 1)),
               InputError);
}

}  // namespace
}  // namespace graze::bvh

#include <graze/bvh/build/build.h>
#include <graze/bvh/error.h>
#include <graze/bvh/refit/refit.h>
#include <graze/bvh/tree/statistics.h>
#include <graze/bvh/tree/validate.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>

#include "tests/bvh/random_boxes.h"

namespace graze::bvh {
namespace {

class BuildOn : public testing::TestWithParam<Distribution> {};

INSTANTIATE_TEST_SUITE_P(Distributions, BuildOn, testing::ValuesIn(kDistributions),
                         testing::PrintToStringParamName());

TEST_P(BuildOn, KeepsItsInvariants) {
  for (std::size_t count : {1, 2, 3, 5, 17, 1000, 20000}) {
    const std::vector<Aabb> boxes = random_boxes(GetParam(), count, count);
    const Tree tree = build(boxes);
    EXPECT_EQ(find_broken_invariant(tree, boxes).value_or(""), "") << count;
    EXPECT_LE(statistics_of(tree).depth, 64 + std::ceil(std::log2(static_cast<double>(count))));
    EXPECT_LE(statistics_of(tree).largest_leaf, 4u);
  }
}

TEST_P(BuildOn, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Aabb> boxes = random_boxes(GetParam(), 30000, 7);
  const auto built_on = [&](std::size_t threads) {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return build(boxes);
  };
  const Tree one = built_on(1);
  for (std::size_t threads : {2, 4}) {
    const Tree many = built_on(threads);
    ASSERT_EQ(one.nodes.size(), many.nodes.size());
    EXPECT_EQ(std::memcmp(one.nodes.data(), many.nodes.data(), one.nodes.size() * sizeof(Node)), 0);
    EXPECT_EQ(one.primitives, many.primitives);
  }
}

TEST_P(BuildOn, RefitFollowsAnyMotion) {
  const std::vector<Aabb> before = random_boxes(GetParam(), 3000, 1);
  Tree tree = build(before);
  for (Distribution distribution : kDistributions) {
    const std::vector<Aabb> after = random_boxes(distribution, 3000, 2);
    refit(tree, after);
    EXPECT_EQ(find_broken_invariant(tree, after).value_or(""), "");
  }
  refit(tree, before);
  const Tree rebuilt = build(before);
  EXPECT_EQ(std::memcmp(&tree.root().box, &rebuilt.root().box, sizeof(FloatBox)), 0);
}

TEST(Build, SplitsCollinearPrimitivesEvenly) {
  const std::vector<Aabb> boxes = random_boxes(Distribution::Collinear, 20000, 3);
  EXPECT_LT(statistics_of(build(boxes)).depth, 30u);
}

TEST(Build, RefusesBadBoxes) {
  EXPECT_THROW(build({}), InputError);
  std::vector<Aabb> boxes = random_boxes(Distribution::Uniform, 3, 1);
  boxes[1].min.x() = std::nan("");
  try {
    build(boxes);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "tree: box 1: box: coordinate x is not finite");
  }
  boxes[1].min.x() = 10;
  EXPECT_THROW(build(boxes), InputError);
}

TEST(Refit, RefusesAnotherNumberOfBoxesAndLeavesTheTree) {
  const std::vector<Aabb> boxes = random_boxes(Distribution::Uniform, 50, 1);
  Tree tree = build(boxes);
  EXPECT_THROW(refit(tree, random_boxes(Distribution::Uniform, 49, 1)), InputError);
  EXPECT_EQ(find_broken_invariant(tree, boxes).value_or(""), "");
}

TEST(Statistics, OfAKnownTree) {
  Tree tree;
  tree.frame = LocalFrame::around({Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()});
  tree.nodes = {{{{0, 0, 0}, {2, 1, 1}}, 1, 0},
                {{{0, 0, 0}, {1, 1, 1}}, 0, 2},
                {{{1, 0, 0}, {2, 1, 1}}, 2, 1}};
  tree.primitives = {0, 1, 2};
  const TreeStatistics statistics = statistics_of(tree);
  EXPECT_EQ(statistics.node_count, 3u);
  EXPECT_EQ(statistics.leaf_count, 2u);
  EXPECT_EQ(statistics.depth, 1u);
  EXPECT_EQ(statistics.largest_leaf, 2u);
  EXPECT_DOUBLE_EQ(statistics.mean_leaf_size, 1.5);
  EXPECT_DOUBLE_EQ(statistics.expected_node_visits, 1 + 0.6 + 0.6);
  EXPECT_DOUBLE_EQ(statistics.expected_primitive_tests, 0.6 * 2 + 0.6);
  EXPECT_EQ(statistics.bytes, 3 * 32 + 3 * 4u);
}

// The checker itself must bite: each kind of damage is found.
TEST(Validate, FindsDamage) {
  const std::vector<Aabb> boxes = random_boxes(Distribution::Uniform, 100, 1);
  const Tree good = build(boxes);
  const auto broken = [&](auto&& damage) {
    Tree tree = good;
    damage(tree);
    return find_broken_invariant(tree, boxes).has_value();
  };
  ASSERT_FALSE(broken([](Tree&) {}));
  EXPECT_TRUE(broken([](Tree& tree) { tree.nodes[0].box.max[1] -= 0.5f; }));
  EXPECT_TRUE(broken([](Tree& tree) { tree.nodes.back().box.min[0] += 1e-3f; }));
  EXPECT_TRUE(broken([](Tree& tree) { tree.nodes[0].first = 0; }));
  EXPECT_TRUE(broken([](Tree& tree) { tree.nodes[0].first = 1000; }));
  EXPECT_TRUE(broken([](Tree& tree) { tree.primitives[3] = tree.primitives[4]; }));
  EXPECT_TRUE(broken([](Tree& tree) { tree.primitives[3] = 100; }));
  EXPECT_TRUE(broken([](Tree& tree) { tree.primitives.pop_back(); }));
  EXPECT_TRUE(broken([](Tree& tree) { tree.nodes.pop_back(); }));
  EXPECT_TRUE(broken([](Tree& tree) { tree.nodes.clear(); }));
}

}  // namespace
}  // namespace graze::bvh

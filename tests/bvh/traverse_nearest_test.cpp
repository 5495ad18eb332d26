#include <graze/bvh/build/build.h>
#include <graze/bvh/traverse/traverse_nearest.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "tests/bvh/random_boxes.h"

namespace graze::bvh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The square of the distance from a box to a point, in the tree's units.
double square_to(const FloatBox& box, const FloatBox& point) {
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    const double gap = std::max({0.0, double{box.min[k]} - double{point.max[k]},
                                 double{point.min[k]} - double{box.max[k]}});
    square += gap * gap;
  }
  return square;
}

/// Nodes by their distance from a point; what is farther than `missed` is dropped when it is found.
struct Distances {
  const Tree& tree;
  const FloatBox& point;
  const double& limit;
  double missed = kInfinity;
  mutable std::size_t asked = 0;

  double of(std::uint32_t node) const {
    ++asked;
    return square_to(tree.nodes[node].box, point);
  }
  bool is_missed(double bound) const { return bound > missed; }
  bool is_beyond(double bound) const { return bound > limit; }
};

class TraverseNearest : public testing::TestWithParam<Distribution> {};

INSTANTIATE_TEST_SUITE_P(Distributions, TraverseNearest, testing::ValuesIn(kDistributions),
                         testing::PrintToStringParamName());

TEST_P(TraverseNearest, FindsTheNearestOfAll) {
  const std::vector<Aabb> boxes = random_boxes(GetParam(), 500, 1);
  const Tree tree = build(boxes);
  for (std::size_t probe = 0; probe < 50; ++probe) {
    const FloatBox point = tree.frame.to_local({boxes[probe].min, boxes[probe].min});
    double expected = kInfinity, best = kInfinity;
    for (const Node& node : tree.nodes) {
      if (node.is_leaf()) expected = std::min(expected, square_to(node.box, point));
    }
    const Distances distances{tree, point, best};
    const auto leaf_fn = [&](const Node& leaf) {
      best = std::min(best, square_to(leaf.box, point));
      return Walk::Continue;
    };
    EXPECT_EQ(traverse_nearest(tree, distances, leaf_fn), Walk::Continue);
    ASSERT_EQ(best, expected);
    EXPECT_LE(distances.asked, tree.nodes.size()) << "a node was asked for twice";
  }
}

TEST_P(TraverseNearest, CallsForEachLeafWithinTheLimitOnce) {
  const Tree tree = build(random_boxes(GetParam(), 300, 2));
  const FloatBox point = tree.nodes[tree.nodes.size() / 2].box;
  std::vector<double> squares;
  for (const Node& node : tree.nodes) {
    if (node.is_leaf()) squares.push_back(square_to(node.box, point));
  }
  std::sort(squares.begin(), squares.end());
  const double limit = squares[squares.size() / 2];
  for (const double missed : {kInfinity, limit}) {
    const Distances distances{tree, point, limit, missed};
    std::vector<double> seen;
    traverse_nearest(tree, distances, [&](const Node& leaf) {
      seen.push_back(square_to(leaf.box, point));
      return Walk::Continue;
    });
    std::sort(seen.begin(), seen.end());
    const auto end = std::upper_bound(squares.begin(), squares.end(), limit);
    EXPECT_EQ(seen, std::vector<double>(squares.begin(), end)) << missed;
  }
}

/// Boxes of edge 1 in a row along x, so that nearer children hold nearer leaves.
Tree row_of(int count) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < count; ++i)
    boxes.push_back({{2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}});
  return build(boxes);
}

TEST(TraverseNearestOrder, IsFromNearToFarAlongARow) {
  const Tree tree = row_of(200);
  for (const double at : {-5.0, 1000.0}) {
    const FloatBox point = tree.frame.to_local({{at, 0, 0}, {at, 0, 0}});
    double last = -1;
    const Distances distances{tree, point, kInfinity};
    traverse_nearest(tree, distances, [&](const Node& leaf) {
      const double square = square_to(leaf.box, point);
      EXPECT_GE(square, last);
      last = square;
      return Walk::Continue;
    });
  }
}

TEST(TraverseNearestOrder, StopsWhenTold) {
  const Tree tree = row_of(200);
  const FloatBox point = tree.root().box;
  const Distances distances{tree, point, kInfinity};
  int leaves = 0;
  const auto stop_at_third = [&](const Node&) {
    return ++leaves == 3 ? Walk::Stop : Walk::Continue;
  };
  EXPECT_EQ(traverse_nearest(tree, distances, stop_at_third), Walk::Stop);
  EXPECT_EQ(leaves, 3);
}

TEST(TraverseNearestOrder, OfAMissedRootNothingIsCalled) {
  const Tree tree = row_of(20);
  const FloatBox point = tree.frame.to_local({{-5, 0, 0}, {-5, 0, 0}});
  const Distances distances{tree, point, kInfinity, 0};
  traverse_nearest(tree, distances, [&](const Node&) {
    ADD_FAILURE() << "a leaf below it was called for";
    return Walk::Continue;
  });
  EXPECT_EQ(distances.asked, 1u);
}

}  // namespace
}  // namespace graze::bvh

#include <graze/bvh/build/build.h>
#include <graze/bvh/skins/node_separation.h>
#include <graze/bvh/traverse/traverse_cut.h>
#include <graze/bvh/traverse/traverse_pair.h>
#include <graze/bvh/traverse/traverse_self.h>
#include <graze/bvh/traverse/traverse_volume.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "tests/bvh/random_boxes.h"

namespace graze::bvh {
namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

bool overlap(const Aabb& a, const Aabb& b) {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

/// Calls fn(i) for each primitive of a leaf.
template <typename Fn>
void for_each_primitive(const Tree& tree, const Node& leaf, Fn&& fn) {
  for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i)
    fn(tree.primitives[i]);
}

struct NeverApart {
  bool are_apart(std::uint32_t, std::uint32_t) const { return false; }
  bool is_first_larger(std::uint32_t, std::uint32_t) const { return false; }
};

class TraverseOn : public testing::TestWithParam<Distribution> {};

INSTANTIATE_TEST_SUITE_P(Distributions, TraverseOn, testing::ValuesIn(kDistributions),
                         testing::PrintToStringParamName());

TEST_P(TraverseOn, SelfIsBruteForce) {
  const std::vector<Aabb> boxes = random_boxes(GetParam(), 400, 1);
  const Tree tree = build(boxes);
  Pairs expected, found;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (overlap(boxes[i], boxes[j])) expected.insert({i, j});
    }
  }
  std::size_t visits = 0;
  traverse_self(tree, NodeOverlap(tree.nodes, tree.nodes), [&](const Node& a, const Node& b) {
    for_each_primitive(tree, a, [&](std::uint32_t i) {
      for_each_primitive(tree, b, [&](std::uint32_t j) {
        if (&a == &b && i >= j) return;
        ++visits;
        if (overlap(boxes[i], boxes[j])) found.insert(std::minmax(i, j));
      });
    });
    return Walk::Continue;
  });
  EXPECT_EQ(found, expected);
  EXPECT_LE(visits, boxes.size() * (boxes.size() - 1) / 2) << "a pair came twice";
}

TEST_P(TraverseOn, VolumeIsBruteForce) {
  const std::vector<Aabb> boxes = random_boxes(GetParam(), 500, 1);
  const Tree tree = build(boxes);
  for (std::size_t probe = 0; probe < 50; ++probe) {
    const FloatBox local = tree.frame.to_local(boxes[probe]);
    std::set<std::uint32_t> expected, found;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (overlap(boxes[i], boxes[probe])) expected.insert(i);
    }
    traverse_volume(
        tree, [&](std::uint32_t node) { return !overlap(tree.nodes[node].box, local); },
        [&](const Node& leaf) {
          for_each_primitive(tree, leaf, [&](std::uint32_t i) {
            if (overlap(boxes[i], boxes[probe])) found.insert(i);
          });
          return Walk::Continue;
        });
    ASSERT_EQ(found, expected);
  }
}

TEST_P(TraverseOn, PairIsBruteForce) {
  const std::vector<Aabb> boxes_a = random_boxes(GetParam(), 300, 1);
  std::vector<Aabb> boxes_b = random_boxes(GetParam(), 200, 2);
  const Tree tree_a = build(boxes_a);
  Tree tree_b = build(boxes_b);
  // In one frame, so that the boxes of both trees compare.
  tree_b.frame = tree_a.frame;
  for (std::size_t i = tree_b.nodes.size(); i-- > 0;) {
    Node& node = tree_b.nodes[i];
    node.box = empty_box();
    if (!node.is_leaf()) {
      node.box = merged(tree_b.nodes[node.first].box, tree_b.nodes[node.first + 1].box);
    } else {
      for_each_primitive(tree_b, node, [&](std::uint32_t k) {
        node.box = merged(node.box, tree_b.frame.to_local(boxes_b[k]));
      });
    }
  }
  Pairs expected, found;
  for (std::uint32_t i = 0; i < boxes_a.size(); ++i) {
    for (std::uint32_t j = 0; j < boxes_b.size(); ++j) {
      if (overlap(boxes_a[i], boxes_b[j])) expected.insert({i, j});
    }
  }
  std::size_t visits = 0;
  traverse_pair(tree_a, tree_b, NodeOverlap(tree_a.nodes, tree_b.nodes),
                [&](const Node& a, const Node& b) {
                  for_each_primitive(tree_a, a, [&](std::uint32_t i) {
                    for_each_primitive(tree_b, b, [&](std::uint32_t j) {
                      ++visits;
                      if (overlap(boxes_a[i], boxes_b[j])) found.insert({i, j});
                    });
                  });
                  return Walk::Continue;
                });
  EXPECT_EQ(found, expected);
  EXPECT_LE(visits, boxes_a.size() * boxes_b.size()) << "a pair came twice";
}

TEST(Traverse, StopsWhenTold) {
  const std::vector<Aabb> boxes = random_boxes(Distribution::OnePoint, 1000, 1);
  const Tree tree = build(boxes);
  const NeverApart never;
  int leaves = 0;
  const auto stop_at_third = [&](const Node&, const Node&) {
    return ++leaves == 3 ? Walk::Stop : Walk::Continue;
  };
  EXPECT_EQ(traverse_pair(tree, tree, never, stop_at_third), Walk::Stop);
  EXPECT_EQ(leaves, 3);
  leaves = 0;
  EXPECT_EQ(traverse_self(tree, never, stop_at_third), Walk::Stop);
  EXPECT_EQ(leaves, 3);
  leaves = 0;
  EXPECT_EQ(traverse_volume(
                tree, [](std::uint32_t) { return false; },
                [&](const Node&) { return ++leaves == 3 ? Walk::Stop : Walk::Continue; }),
            Walk::Stop);
  EXPECT_EQ(leaves, 3);
  leaves = 0;
  const std::uint32_t root[] = {0};
  const auto is_none = [](std::uint32_t) { return false; };
  EXPECT_EQ(
      traverse_cut(tree, root, is_none, is_none,
                   [&](std::uint32_t) { return ++leaves == 3 ? Walk::Stop : Walk::Continue; }),
      Walk::Stop);
  EXPECT_EQ(leaves, 3);
}

TEST(TraversalStack, GrowsBeyondItsInlinePartAndKeepsOrder) {
  TraversalStack<int, 4> stack;
  for (int i = 0; i < 1000; ++i)
    stack.push(i);
  for (int i = 999; i >= 0; --i)
    ASSERT_EQ(stack.pop(), i);
  EXPECT_TRUE(stack.empty());
}

TEST(TraversalStack, GivesEveryOtherEntryAwayAndKeepsTheRestInOrder) {
  for (const int size : {0, 1, 2, 4, 5, 7, 8, 9, 11}) {
    TraversalStack<int, 4> stack;
    for (int i = 0; i < size; ++i)
      stack.push(i);
    std::vector<int> taken;
    stack.take_half([&](int entry) { taken.push_back(entry); });
    ASSERT_EQ(taken.size(), static_cast<std::size_t>((size + 1) / 2));
    for (std::size_t i = 0; i < taken.size(); ++i)
      EXPECT_EQ(taken[i], static_cast<int>(2 * i));
    stack.push(100);  // on top of what is left, wherever that lies
    EXPECT_EQ(stack.pop(), 100);
    for (int i = size - 1; i >= 0; --i) {
      if (i % 2 == 1) {
        ASSERT_EQ(stack.pop(), i);
      }
    }
    EXPECT_TRUE(stack.empty());
  }
}

}  // namespace
}  // namespace graze::bvh

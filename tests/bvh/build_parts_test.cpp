#include <graze/bvh/build/build_references.h>
#include <graze/bvh/build/sah_sweep.h>
#include <graze/bvh/build/subtree.h>
#include <graze/bvh/build/top_split.h>
#include <graze/bvh/error.h>
#include <graze/bvh/tree/statistics.h>
#include <graze/bvh/tree/validate.h>
#include <graze/bvh/value/to_local.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "tests/bvh/random_boxes.h"

namespace graze::bvh {
namespace {

bool is_same(const FloatBox& a, const FloatBox& b) {
  return std::memcmp(&a, &b, sizeof(FloatBox)) == 0;
}

LocalFrame frame_around(const std::vector<Aabb>& boxes) {
  Aabb all = boxes[0];
  for (const Aabb& box : boxes)
    all = {all.min.cwiseMin(box.min), all.max.cwiseMax(box.max)};
  return LocalFrame::around(all);
}

class BuildPartsOn : public testing::TestWithParam<Distribution> {};

INSTANTIATE_TEST_SUITE_P(Distributions, BuildPartsOn, testing::ValuesIn(kDistributions),
                         testing::PrintToStringParamName());

TEST_P(BuildPartsOn, ReferencesAreBoxesRoundedOneByOne) {
  const std::vector<Aabb> boxes = random_boxes(GetParam(), 300, 4);
  const LocalFrame frame = frame_around(boxes);
  const ToLocal to_local(frame);
  References references = references_to(boxes, frame);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Aabb& box = boxes[i];
    const FloatBox expected = frame.to_local(box);
    EXPECT_TRUE(is_same(float_box(references.all()[i].box), expected)) << i;
    EXPECT_EQ(references.all()[i].index(), i);
    const Eigen::Vector3d corner(box.max.x(), box.min.y(), box.min.z());
    EXPECT_TRUE(
        is_same(float_box(to_local.box(corner.data(), box.max.data(), box.min.data())), expected));
  }
}

/// The tree that parts make, put together by recursion from the top down and compared with one that
/// was built at once.
class Comparison {
 public:
  Comparison(const Tree& tree, std::span<Reference> references, std::size_t part_size)
      : tree_(tree), references_(references), top_(split_top(references, part_size, {})) {
    for (const Part& part : top_.parts) {
      EXPECT_LE(part.size(), part_size);
      subtrees_.push_back({});
    }
    // Any order will do.
    for (std::size_t i = top_.parts.size(); i-- > 0;)
      subtrees_[i] = build_subtree(references, top_.parts[i], {});
  }

  bool is_same_below_top(std::size_t a, std::size_t b) const {
    const Node& node = tree_.nodes[a];
    const Node& other = top_.nodes[b];
    if (!is_same(node.box, other.box)) return false;
    if (other.is_leaf()) {
      return other.count == top_.parts[other.first].size() && is_same_in_part(a, other.first, 0);
    }
    return !node.is_leaf() && is_same_below_top(node.first, other.first) &&
           is_same_below_top(node.first + 1, other.first + 1);
  }

 private:
  bool is_same_in_part(std::size_t a, std::size_t part, std::size_t b) const {
    const Node& node = tree_.nodes[a];
    const Node& other = subtrees_[part][b];
    if (!is_same(node.box, other.box) || node.count != other.count) return false;
    if (!node.is_leaf()) {
      return is_same_in_part(node.first, part, other.first) &&
             is_same_in_part(node.first + 1, part, other.first + 1);
    }
    const std::size_t first = top_.parts[part].begin + other.first;
    if (node.first != first) return false;
    for (std::size_t i = first; i < first + node.count; ++i) {
      if (tree_.primitives[i] != references_[i].index()) return false;
    }
    return true;
  }

  const Tree& tree_;
  std::span<Reference> references_;
  TopTree top_;
  std::vector<std::vector<Node>> subtrees_;
};

TEST_P(BuildPartsOn, IsTheSameTreeForAnyPartSize) {
  const std::vector<Aabb> boxes = random_boxes(GetParam(), 10000, 5);
  const LocalFrame frame = frame_around(boxes);
  const Tree tree = build(boxes);
  for (std::size_t part_size : {4, 60, 700, 4096, 20000}) {
    References references = references_to(boxes, frame);
    const Comparison parts(tree, references.all(), part_size);
    EXPECT_TRUE(parts.is_same_below_top(0, 0)) << part_size;
  }
}

/// What the surface area heuristic says of all trees over a few boxes: by every way to put them on
/// two sides, over and over.
class BruteForce {
 public:
  BruteForce(std::vector<FloatBox> boxes, const BuildSettings& settings)
      : boxes_(std::move(boxes)), settings_(settings) {}

  /// Of the boxes whose bits are set, times half the surface of all.
  double cheapest(unsigned members) const {
    FloatBox all = empty_box();
    unsigned count = 0;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (members >> i & 1) {
        all = merged(all, boxes_[i]);
        ++count;
      }
    }
    const double surface = half_surface(all);
    double best = std::numeric_limits<double>::infinity();
    if (count <= std::max(1u, settings_.max_leaf_size))
      best = settings_.primitive_cost * count * surface;
    for (unsigned side = (members - 1) & members; side > 0; side = (side - 1) & members)
      best = std::min(best, surface + cheapest(side) + cheapest(members & ~side));
    return best;
  }

 private:
  std::vector<FloatBox> boxes_;
  BuildSettings settings_;
};

/// Inner nodes cost one, primitives what they are said to.
double cost_of(const Tree& tree, const BuildSettings& settings) {
  double cost = 0;
  for (const Node& node : tree.nodes) {
    const double share = half_surface(node.box);
    cost += node.is_leaf() ? share * settings.primitive_cost * node.count : share;
  }
  return cost;
}

TEST(BuildQuartet, IsTheCheapestOfAllTrees) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const std::size_t count = 2 + seed % 3;
    const BuildSettings settings{.max_leaf_size = static_cast<std::uint32_t>(1 + seed / 3 % 5),
                                 .primitive_cost = seed % 2 == 0 ? 1.5f : 0.75f};
    const Distribution distribution = seed % 5 == 0 ? Distribution::Flat : Distribution::Uniform;
    std::vector<Aabb> boxes = random_boxes(distribution, count, seed);
    // Large ones, which overlap, so that leaves of several pay.
    for (Aabb& box : boxes)
      box.max += (seed % 7) * (box.max - box.min);
    const Tree tree = build(boxes, settings);
    ASSERT_EQ(find_broken_invariant(tree, boxes).value_or(""), "");
    ASSERT_LE(statistics_of(tree).largest_leaf, settings.max_leaf_size);
    std::vector<FloatBox> local;
    for (const Aabb& box : boxes)
      local.push_back(tree.frame.to_local(box));
    const double best = BruteForce(local, settings).cheapest((1u << count) - 1);
    EXPECT_NEAR(cost_of(tree, settings), best, 1e-5 * best) << seed;
  }
}

TEST(SweepCosts, PlacesThatLeavesLeaveEmptyCountToo) {
  const SweepCosts costs{.leaf_size = 4, .empty_place = 0.5f};
  const Lanes few = weight_of(Lanes{0, 1, 3, 4}, costs);
  const Lanes more = weight_of(Lanes{5, 8, 9, 1000}, costs);
  EXPECT_EQ(few[0], 0);
  EXPECT_EQ(few[1], 2.5f);
  EXPECT_EQ(few[2], 3.5f);
  EXPECT_EQ(few[3], 4);
  EXPECT_EQ(more[0], 6.5f);
  EXPECT_EQ(more[1], 8);
  EXPECT_EQ(more[2], 10.5f);
  EXPECT_EQ(more[3], 1000);
}

// A side without primitives weighs nothing, however large leaves may be: it must not be chosen.
TEST(SweepCosts, NothingWeighsNothing) {
  for (const float size : {1.0f, 3.0f, 0x1p24f, 0x1p32f}) {
    const SweepCosts costs{.leaf_size = size, .empty_place = 1};
    EXPECT_EQ(weight_of(all_lanes(0), costs)[0], 0) << size;
    EXPECT_EQ(weight_of(all_lanes(1), costs)[0], size);
  }
  for (const std::uint32_t size : {0u, 1u, 0xffffffffu}) {
    for (const Distribution distribution : {Distribution::Collinear, Distribution::Uniform}) {
      const std::vector<Aabb> boxes = random_boxes(distribution, 500, 4);
      const Tree tree =
          build(boxes, {.max_leaf_size = size, .primitive_cost = 100, .empty_place_cost = 0.5f});
      EXPECT_EQ(find_broken_invariant(tree, boxes).value_or(""), "") << size;
    }
  }
}

// Three boxes and, far from them, two: apart they cost one visit, and the boxes of both sides are
// small. Together they leave three places of eight empty.
TEST(SweepCosts, ALeafPaysForItsEmptyPlaces) {
  std::vector<Aabb> boxes;
  for (const double x : {0.0, 1.0, 2.0, 1000.0, 1001.0})
    boxes.push_back({{x, 0, 0}, {x + 1, 1, 1}});
  const auto leaves_at = [&](float cost) {
    return statistics_of(
               build(boxes,
                     {.max_leaf_size = 8, .primitive_cost = 0.16f, .empty_place_cost = cost}))
        .leaf_count;
  };
  EXPECT_EQ(leaves_at(0), 1u);
  EXPECT_EQ(leaves_at(1), 2u);
}

TEST(SweepCosts, ThePriceOfAPlaceIsChecked) {
  const std::vector<Aabb> boxes = random_boxes(Distribution::Uniform, 9, 1);
  for (const float cost : {-0.1f, 1.1f, std::numeric_limits<float>::infinity(), std::nanf("")})
    EXPECT_THROW(build(boxes, {.empty_place_cost = cost}), InputError) << cost;
}

TEST(SweepCosts, DearerPlacesMakeFewerLeaves) {
  const std::vector<Aabb> boxes = random_boxes(Distribution::Uniform, 20000, 3);
  const auto leaves_at = [&](float cost) {
    const Tree tree = build(boxes, {.primitive_cost = 0.1f, .empty_place_cost = cost});
    EXPECT_EQ(find_broken_invariant(tree, boxes).value_or(""), "");
    return static_cast<double>(statistics_of(tree).leaf_count);
  };
  EXPECT_LT(leaves_at(0.5f), 0.95 * leaves_at(0));
  EXPECT_LE(leaves_at(1), leaves_at(0.5f));
}

}  // namespace
}  // namespace graze::bvh

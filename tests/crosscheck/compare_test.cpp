// The judge on trial: answers that are wrong on purpose must be found so.

#include <graze/engine/compare/compare.h>
#include <gtest/gtest.h>

#include "tests/shapes/formula_meshes.h"

namespace graze::compare {
namespace {

using Pairs = std::vector<TrianglePair>;

/// Two rows crossing in exactly the pairs (i, i).
class Compare : public testing::Test {
 protected:
  Compare() {
    crossing_.linear() =
        Eigen::AngleAxisd(-0.5 * EIGEN_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
    crossing_.translation() << 0.25, 0.25, 0.5;
  }

  Comparison compare(const Pairs& graze_pairs, const Pairs& fcl_pairs) const {
    return compare_pairs(graze_pairs, fcl_pairs, {row_}, {row_, crossing_});
  }

  Comparison compare(bool graze_says, bool fcl_says, const Pairs& witnesses) const {
    return compare_any(graze_says, fcl_says, witnesses, {row_}, {row_, crossing_});
  }

  Mesh row_ = tests::make_row(4);
  Pose crossing_ = Pose::Identity();
};

void expect_difference(const Difference& difference, const TrianglePair& pair, bool graze_says,
                       bool truth) {
  EXPECT_EQ(difference.pair, pair);
  EXPECT_EQ(difference.graze_says, graze_says);
  EXPECT_EQ(difference.fcl_says, !graze_says);
  EXPECT_EQ(difference.truth, truth);
}

TEST_F(Compare, EqualListsHaveNoDifferences) {
  const Comparison same = compare({{0, 0}, {1, 1}}, {{0, 0}, {1, 1}});
  EXPECT_TRUE(same.graze_intersects && same.fcl_intersects);
  EXPECT_EQ(same.graze_pairs, 2u);
  EXPECT_EQ(same.fcl_pairs, 2u);
  EXPECT_TRUE(same.differences.empty());
  EXPECT_EQ(same.graze_wrong + same.fcl_wrong, 0u);
}

TEST_F(Compare, APairThatGrazeMissesIsItsFault) {
  const Comparison missed = compare({{0, 0}}, {{0, 0}, {2, 2}});
  ASSERT_EQ(missed.differences.size(), 1u);
  expect_difference(missed.differences[0], {2, 2}, false, true);
  EXPECT_EQ(missed.graze_wrong, 1u);
  EXPECT_EQ(missed.fcl_wrong, 0u);
}

TEST_F(Compare, APairThatGrazeInventsIsItsFault) {
  const Comparison invented = compare({{0, 0}, {0, 1}}, {{0, 0}});
  ASSERT_EQ(invented.differences.size(), 1u);
  expect_difference(invented.differences[0], {0, 1}, true, false);
  EXPECT_EQ(invented.graze_wrong, 1u);
  EXPECT_EQ(invented.fcl_wrong, 0u);
}

TEST_F(Compare, FclIsJudgedLikewise) {
  const Comparison both = compare({{0, 0}, {1, 1}}, {{1, 1}, {3, 2}});
  ASSERT_EQ(both.differences.size(), 2u);
  expect_difference(both.differences[0], {0, 0}, true, true);
  expect_difference(both.differences[1], {3, 2}, false, false);
  EXPECT_EQ(both.graze_wrong, 0u);
  EXPECT_EQ(both.fcl_wrong, 2u);
}

TEST_F(Compare, PosesDecideWhatIsTrue) {
  Pose apart = crossing_;
  apart.translation().z() = 5;
  const Comparison moved = compare_pairs(Pairs{{0, 0}}, Pairs{}, {row_}, {row_, apart});
  EXPECT_EQ(moved.graze_wrong, 1u);
}

TEST_F(Compare, BooleanAnswersThatAgreeAreNotSettled) {
  for (bool answer : {false, true}) {
    const Comparison same = compare(answer, answer, {});
    EXPECT_EQ(same.graze_intersects, answer);
    EXPECT_EQ(same.fcl_intersects, answer);
    EXPECT_TRUE(same.differences.empty());
    EXPECT_EQ(same.graze_wrong + same.fcl_wrong, 0u);
  }
}

TEST_F(Compare, AWitnessDecidesABooleanDifference) {
  const Comparison found = compare(false, true, {{0, 1}, {2, 2}, {3, 3}});
  ASSERT_EQ(found.differences.size(), 1u);
  expect_difference(found.differences[0], {2, 2}, false, true);
  EXPECT_EQ(found.graze_wrong, 1u);
  EXPECT_EQ(found.fcl_wrong, 0u);
}

TEST_F(Compare, AYesWithoutATrueWitnessIsWrong) {
  const Comparison unfounded = compare(true, false, {{0, 1}, {1, 2}});
  ASSERT_EQ(unfounded.differences.size(), 1u);
  expect_difference(unfounded.differences[0], {0, 1}, true, false);
  EXPECT_EQ(unfounded.graze_wrong, 1u);
  const Comparison empty = compare(false, true, {});
  EXPECT_TRUE(empty.differences.empty());
  EXPECT_EQ(empty.fcl_wrong, 1u);
  EXPECT_EQ(empty.graze_wrong, 0u);
}

}  // namespace
}  // namespace graze::compare

#include <graze/engine/mesh/memory/motion_front.h>
#include <gtest/gtest.h>

namespace graze {
namespace {

TEST(FrontWorth, NothingSpeaksAgainstAFrontThatNobodyHasTried) {
  FrontWorth worth;
  worth.learn(1e9);
  EXPECT_TRUE(worth.is_worth_it());
  worth.learn_walk(1);
  worth.begin();
  EXPECT_TRUE(worth.is_worth_it());
  EXPECT_FALSE(worth.is_surely_worth_it());
}

TEST(FrontWorth, NothingIsSureAsLongAsNobodyHasWalked) {
  FrontWorth worth;
  for (int i = 0; i < 10; ++i)
    worth.learn(1);
  EXPECT_TRUE(worth.is_worth_it());
  EXPECT_FALSE(worth.is_surely_worth_it());
}

TEST(FrontWorth, WhatCostsMoreThanAWalkIsNotWorthIt) {
  FrontWorth worth;
  worth.learn_walk(100);
  for (int i = 0; i < 3; ++i) {
    worth.learn(150);
    EXPECT_TRUE(worth.is_worth_it()) << i;
  }
  worth.learn(150);
  EXPECT_FALSE(worth.is_worth_it());
  for (int i = 0; i < 10; ++i)
    worth.learn(10);
  EXPECT_TRUE(worth.is_worth_it());
  EXPECT_TRUE(worth.is_surely_worth_it());
}

TEST(FrontWorth, WhatCostsFarMoreIsGivenUpAtOnce) {
  FrontWorth worth;
  worth.learn_walk(100);
  worth.learn(250);
  EXPECT_FALSE(worth.is_worth_it());
}

TEST(FrontWorth, AFrontIsNotJudgedByTheOneBefore) {
  FrontWorth worth;
  worth.learn_walk(100);
  for (int i = 0; i < 10; ++i)
    worth.learn(1000);
  worth.begin();
  EXPECT_TRUE(worth.is_worth_it());
  worth.learn(90);
  EXPECT_TRUE(worth.is_worth_it());
  EXPECT_FALSE(worth.is_surely_worth_it());
}

TEST(FrontWorth, EachThingThatIsDoneCostsSomething) {
  const double walk = FrontWorth::cost_of_walk({});
  EXPECT_GT(FrontWorth::cost_of_walk({.volume_tests = 1}), walk);
  EXPECT_GT(FrontWorth::cost_of_walk({.filter_tests = 1}), walk);
  EXPECT_GT(FrontWorth::cost_of_walk({.triangle_tests = 1}), walk);
  const double pass = FrontWorth::cost_of_pass({}, 0);
  EXPECT_GT(pass, walk);
  EXPECT_GT(FrontWorth::cost_of_pass({.walk = {.box_tests = 1, .treelets = {}}, .skipped = 0}, 0),
            pass);
  EXPECT_GT(
      FrontWorth::cost_of_pass({.walk = {.primitive_tests = 1, .treelets = {}}, .skipped = 0}, 0),
      pass);
  EXPECT_GT(FrontWorth::cost_of_pass({.walk = {}, .skipped = 1}, 0), pass);
  EXPECT_GT(FrontWorth::cost_of_pass({}, 1), pass);
}

}  // namespace
}  // namespace graze

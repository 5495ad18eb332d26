#include <graze/engine/mesh/memory/front_reach.h>
#include <gtest/gtest.h>

#include <vector>

namespace graze {
namespace {

TEST(FrontReach, GoesFurtherAsLongAsQueriesCostLess) {
  FrontReach reach;
  EXPECT_EQ(reach.queries(), 0);
  double cost = 100;
  std::vector<double> seen;
  for (int i = 0; i < 6; ++i) {
    reach.learn(cost);
    cost /= 2;
    seen.push_back(reach.queries());
  }
  EXPECT_EQ(seen, (std::vector<double>{2, 4, 8, 8, 8, 8}));
}

/// How many of so many passes look ahead where that makes queries twice as dear.
int tries_in_vain(int passes) {
  FrontReach reach;
  int tries = 0;
  for (int i = 0; i < passes; ++i) {
    const bool is_try = reach.queries() > 0;
    tries += is_try;
    reach.learn(is_try ? 20 : 10);
  }
  return tries;
}

TEST(FrontReach, TriesInVainEverMoreSeldom) {
  EXPECT_EQ(tries_in_vain(10), 2);
  EXPECT_EQ(tries_in_vain(100), 5);
  EXPECT_LT(tries_in_vain(1000), 22);
  EXPECT_GT(tries_in_vain(1000), 15);
}

TEST(FrontReach, GoesBackWhereTheNextStepIsTooFar) {
  FrontReach reach;
  for (int i = 0; i < 200; ++i)
    reach.learn(reach.queries() == 2 ? 5 : 10);
  // All but the tries are spent at the best one.
  int at_best = 0;
  for (int i = 0; i < 100; ++i) {
    at_best += reach.queries() == 2;
    reach.learn(reach.queries() == 2 ? 5 : 10);
  }
  EXPECT_GT(at_best, 90);
}

TEST(FrontReach, NoticesThatItHasBecomeWorthIt) {
  FrontReach reach;
  for (int i = 0; i < 300; ++i)
    reach.learn(reach.queries() > 0 ? 20 : 10);
  for (int i = 0; i < 80; ++i)
    reach.learn(10 / (1 + reach.queries()));
  EXPECT_EQ(reach.queries(), 8);
}

}  // namespace
}  // namespace graze

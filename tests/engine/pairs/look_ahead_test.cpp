#include <graze/engine/mesh/memory/motion_front.h>
#include <gtest/gtest.h>

#include <vector>

namespace graze {
namespace {

TEST(LookAhead, GoesFurtherAsLongAsQueriesCostLess) {
  LookAhead look_ahead;
  EXPECT_EQ(look_ahead.queries(), 0);
  double cost = 100;
  std::vector<double> seen;
  for (int i = 0; i < 6; ++i) {
    look_ahead.learn(cost);
    cost /= 2;
    seen.push_back(look_ahead.queries());
  }
  EXPECT_EQ(seen, (std::vector<double>{2, 4, 8, 8, 8, 8}));
}

/// How many of so many passes look ahead where that makes queries twice as dear.
int tries_in_vain(int passes) {
  LookAhead look_ahead;
  int tries = 0;
  for (int i = 0; i < passes; ++i) {
    const bool is_try = look_ahead.queries() > 0;
    tries += is_try;
    look_ahead.learn(is_try ? 20 : 10);
  }
  return tries;
}

TEST(LookAhead, TriesInVainEverMoreSeldom) {
  EXPECT_EQ(tries_in_vain(10), 2);
  EXPECT_EQ(tries_in_vain(100), 5);
  EXPECT_LT(tries_in_vain(1000), 22);
  EXPECT_GT(tries_in_vain(1000), 15);
}

TEST(LookAhead, GoesBackWhereTheNextStepIsTooFar) {
  LookAhead look_ahead;
  for (int i = 0; i < 200; ++i)
    look_ahead.learn(look_ahead.queries() == 2 ? 5 : 10);
  // All but the tries are spent at the best one.
  int at_best = 0;
  for (int i = 0; i < 100; ++i) {
    at_best += look_ahead.queries() == 2;
    look_ahead.learn(look_ahead.queries() == 2 ? 5 : 10);
  }
  EXPECT_GT(at_best, 90);
}

TEST(LookAhead, NoticesThatItHasBecomeWorthIt) {
  LookAhead look_ahead;
  for (int i = 0; i < 300; ++i)
    look_ahead.learn(look_ahead.queries() > 0 ? 20 : 10);
  for (int i = 0; i < 80; ++i)
    look_ahead.learn(10 / (1 + look_ahead.queries()));
  EXPECT_EQ(look_ahead.queries(), 8);
}

}  // namespace
}  // namespace graze

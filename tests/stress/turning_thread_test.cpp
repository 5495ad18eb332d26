#include <graze/bvh/pose.h>
#include <gtest/gtest.h>

#include "tests/stress/turning_thread.h"

namespace graze::stress {
namespace {

TEST(StressThread, TheRotationDriftsToTheDoorAndNoFurther) {
  TurningNut nut;
  for (int i = 0; i < 20000; ++i)
    EXPECT_LE(check_rigid(nut.next(), "nut"), kMaxRotationDeviation);
  EXPECT_GT(nut.renormalised(), 100u);
  EXPECT_GT(nut.largest_deviation(), kMaxRotationDeviation / 2);
}

void check_turning(std::size_t steps, std::size_t spot_checks) {
  const TurningReport report = turn_nut(GRAZE_DATA_DIR, steps, spot_checks);
  EXPECT_EQ(report.steps, steps);
  EXPECT_EQ(report.hits, 0u) << "the nut turns freely";
  EXPECT_GE(report.spot_checks, spot_checks);
  EXPECT_EQ(report.spot_wrong, 0u);
  EXPECT_EQ(report.shifted_wrong, 0u) << "pushed into the flanks it binds";
  EXPECT_GT(report.renormalised, steps / 1000);
}

TEST(StressThread, ANutTurnsFreely) {
  check_turning(300, 2);
}

TEST(StressThreadSlow, AMillionSteps) {
  check_turning(1000000, 40);
}

}  // namespace
}  // namespace graze::stress

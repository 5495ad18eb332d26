// The bundled meshes at the very double at which they begin to touch.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/stress/flip.h"

namespace graze::stress {
namespace {

class StressFlip : public testing::TestWithParam<std::size_t> {};
class StressFlipSlow : public StressFlip {};

void check_flip(std::size_t index, std::size_t poses) {
  const BundledPair pair = bundled_pairs(GRAZE_DATA_DIR).at(index);
  const Flip flip = find_flip(pair);
  EXPECT_EQ(std::nextafter(flip.apart, flip.hit), flip.hit) << "neighbouring doubles";
  const FlipReport report = report_flip(pair, flip, poses);
  EXPECT_EQ(report.graze_wrong, 0u) << pair.name;
  EXPECT_GE(report.changes, 1u) << "the truth flips where graze does";
  EXPECT_GT(report.hits, 0u);
  EXPECT_LT(report.hits, poses);
  EXPECT_GT(report.near, 0u);
  testing::Test::RecordProperty(
      pair.name, std::to_string(report.fcl_wrong) + " FCL wrong of " + std::to_string(poses));
}

TEST_P(StressFlip, NeverWrongInTheLastDoubles) {
  check_flip(GetParam(), 100);
}

TEST_P(StressFlipSlow, NeverWrongInTheLastDoubles) {
  check_flip(GetParam(), 20000);
}

INSTANTIATE_TEST_SUITE_P(Stress, StressFlip, testing::Values(0u, 1u, 2u));
INSTANTIATE_TEST_SUITE_P(Stress, StressFlipSlow, testing::Values(0u, 1u, 2u));

}  // namespace
}  // namespace graze::stress

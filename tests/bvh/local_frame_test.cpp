#include <graze/bvh/value/local_frame.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace graze::bvh {
namespace {

TEST(Rounding, StepsOutwardAroundEveryDouble) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    const auto digits = static_cast<double>(static_cast<std::int64_t>(random()));
    const double value = std::ldexp(digits, static_cast<int>(random() % 180) - 210);
    ASSERT_LT(static_cast<double>(rounded_down(value)), value);
    ASSERT_GT(static_cast<double>(rounded_up(value)), value);
    ASSERT_LE(std::abs(rounded_up(value) - value), std::abs(value) * 0x1p-22 + 0x1p-148);
  }
}

TEST(Rounding, ZeroHasNeighboursOnBothSides) {
  EXPECT_GT(rounded_up(0.0), 0);
  EXPECT_GT(rounded_up(-0.0), 0);
  EXPECT_LT(rounded_down(0.0), 0);
  EXPECT_GT(rounded_up(1e-300), 0);
  EXPECT_GT(rounded_up(-1e-300), -1e-300);
  EXPECT_LT(rounded_down(1e-300), 1e-300);
}

// An array of pairs, as compilers vectorise it: the step must survive that.
TEST(Rounding, SurvivesVectorisation) {
  double low[64];
  float rounded[64];
  for (int i = 0; i < 64; ++i)
    low[i] = 1.0 + i * 0x1p-40;
  for (int i = 0; i < 64; ++i)
    rounded[i] = rounded_down(low[i]);
  for (int i = 0; i < 64; ++i)
    EXPECT_LT(static_cast<double>(rounded[i]), low[i]);
}

Aabb box(double low, double high) {
  return {Eigen::Vector3d::Constant(low), Eigen::Vector3d::Constant(high)};
}

TEST(LocalFrame, CoordinatesAreBelowTwo) {
  constexpr double kMax = std::numeric_limits<double>::max();
  for (const Aabb& bounds : {box(-1, 1), box(1e9, 1e9 + 1), box(-kMax, kMax), box(0, kMax),
                             box(1e-160, 3e-160), box(-1e150, 2e150), box(5e-324, 1e-320)}) {
    const FloatBox local = LocalFrame::around(bounds).to_local(bounds);
    for (int k = 0; k < 3; ++k) {
      EXPECT_GT(local.min[k], -2.001f);
      EXPECT_LT(local.max[k], 2.001f);
      EXPECT_LT(local.min[k], local.max[k]);
    }
  }
}

TEST(LocalFrame, PointsHaveAFrame) {
  const LocalFrame frame = LocalFrame::around(box(3, 3));
  EXPECT_EQ(frame.exponent, LocalFrame::kMinExponent);
  const FloatBox local = frame.to_local(box(3, 3));
  EXPECT_LT(local.min[0], 0);
  EXPECT_GT(local.max[0], 0);
}

}  // namespace
}  // namespace graze::bvh

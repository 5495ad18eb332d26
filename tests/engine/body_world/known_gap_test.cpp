#include <graze/engine/world/bodies/body_motion.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

TEST(MotionBound, IsNotLessThanWhatAnyPointMoves) {
  RandomSource source(3);
  for (int i = 0; i < 2000; ++i) {
    const double scale = std::exp2(source.uniform(-30, 30));
    const double far = std::exp2(source.uniform(-30, 30));
    const Pose from = tests::random_pose(far, source);
    Pose to = from;
    const Eigen::Vector3d axis = source.vector(-1, 1).normalized();
    const double angle = std::exp2(source.uniform(-30, 1));
    to.linear() = Eigen::AngleAxisd(angle, axis).toRotationMatrix() * to.linear();
    to.translation() += source.vector(-1, 1) * std::exp2(source.uniform(-30, 0));
    const double bound = motion_bound(from, to, scale);
    double most = 0;
    for (int k = 0; k < 20; ++k) {
      const Eigen::Vector3d point = source.vector(-1, 1).normalized() * scale * (1 - 0x1p-50);
      most = std::max(most, (to * point - from * point).norm());
    }
    EXPECT_GE(bound, most);
    const double way = (to.translation() - from.translation()).norm();
    const double rounding = 1e-12 * (far + scale + way);
    EXPECT_LE(bound, way + 1.5 * angle * scale + rounding);
  }
}

TEST(MotionBound, IsInfiniteForWhatHasNoEnd) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(motion_bound(Pose::Identity(), Pose::Identity(), infinity), infinity);
}

TEST(NextDouble, IsThatOfTheStandardLibrary) {
  const double infinity = std::numeric_limits<double>::infinity();
  RandomSource source(4);
  std::vector<double> values = {0.0,
                                -0.0,
                                infinity,
                                -infinity,
                                std::numeric_limits<double>::denorm_min(),
                                -std::numeric_limits<double>::denorm_min(),
                                std::numeric_limits<double>::min(),
                                std::numeric_limits<double>::max(),
                                -std::numeric_limits<double>::max()};
  for (int i = 0; i < 1000; ++i)
    values.push_back(source.uniform(-1, 1) * std::exp2(source.integer(-1070, 1020)));
  for (const double value : values) {
    EXPECT_EQ(next_up(value), std::nextafter(value, infinity)) << value;
    EXPECT_EQ(next_down(value), std::nextafter(value, -infinity)) << value;
  }
  EXPECT_TRUE(std::isnan(next_up(std::nan(""))));
}

TEST(KnownGap, HoldsUntilThePathsHaveClosedTheGap) {
  KnownGap gap;
  EXPECT_FALSE(gap.holds(0, 0));
  EXPECT_FALSE(gap.wants_gap(kMeasuredGap));
  int tests = 1;
  while (!gap.wants_gap(kMeasuredGap))
    ASSERT_LT(++tests, 20);
  gap.set_gap(1, 10, 20);
  EXPECT_TRUE(gap.holds(10, 20));
  EXPECT_TRUE(gap.holds(10.5, 20.4));
  EXPECT_FALSE(gap.holds(10.5, 20.5));
  EXPECT_FALSE(gap.holds(std::numeric_limits<double>::infinity(), 20));
  gap.set_gap(0, 10, 20);
  EXPECT_FALSE(gap.holds(10, 20));
}

TEST(KnownGap, MeasuresSeldomWhatIsSoonUsedUp) {
  KnownGap gap;
  int measured = 0;
  for (int i = 0; i < 1000; ++i)
    measured += gap.wants_gap(kMeasuredGap) ? 1 : 0;
  EXPECT_GT(measured, 3);
  EXPECT_LT(measured, 20);
}

TEST(KnownGap, MeasuresAgainAtOnceWhatLasted) {
  KnownGap gap;
  while (!gap.wants_gap(kMeasuredGap)) {
  }
  for (int i = 0; i < 100; ++i)
    gap.note_skip();
  while (!gap.wants_gap(kMeasuredGap)) {
  }
  EXPECT_TRUE(gap.wants_gap(kMeasuredGap));
}

TEST(KnownGap, MeasuresAtOnceWhatIsMeasuredInNoTime) {
  KnownGap gap;
  EXPECT_TRUE(gap.wants_gap(kQuickGap));
  gap.note_skip();
  EXPECT_FALSE(gap.wants_gap(kQuickGap));
  EXPECT_TRUE(gap.wants_gap(kQuickGap));
  gap.note_skip(), gap.note_skip();
  while (!gap.wants_gap(kQuickGap)) {
  }
  gap.note_skip(), gap.note_skip();
  EXPECT_TRUE(gap.wants_gap(kQuickGap));
}

}  // namespace
}  // namespace graze

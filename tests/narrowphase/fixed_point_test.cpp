#include <graze/narrowphase/predicates/fixed_point.h>
#include <graze/narrowphase/predicates/orientation_stages.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/shapes/random_source.h"

namespace graze::narrowphase {
namespace {

constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kDenormal = std::numeric_limits<double>::denorm_min();

struct Points {
  double p[4][3];

  bool to_fixed(FixedPoint (&fixed)[4]) const {
    const double* const points[4] = {p[0], p[1], p[2], p[3]};
    return to_fixed_point(points, 4, fixed);
  }
};

TEST(FixedPoint, HoldsWhatIsAMultipleOfOneUnitInEachAxis) {
  const Points points{{{0, 0.5, 1e300}, {1, 3, 0}, {-7, 0.25, -1e300}, {5, 0, 1e300}}};
  FixedPoint fixed[4];
  ASSERT_TRUE(points.to_fixed(fixed));
  EXPECT_EQ(fixed[2][0], -7 * fixed[1][0]);
  EXPECT_EQ(fixed[1][1], 6 * fixed[0][1]);
  EXPECT_EQ(fixed[2][2], -fixed[0][2]);
  EXPECT_EQ(fixed[0][0], 0);
  EXPECT_EQ(fixed[1][2], 0);
  for (const FixedPoint& point : fixed) {
    for (std::int64_t coordinate : point)
      EXPECT_LT(std::abs(coordinate), std::int64_t{1} << 60);
  }
}

TEST(FixedPoint, SixtyBitsAreTheLimit) {
  const auto fits = [](double large, double small) {
    FixedPoint fixed[4];
    return Points{{{large, 0, 0}, {small, 0, 0}, {0, 0, 0}, {0, 0, 0}}}.to_fixed(fixed);
  };
  // The largest is below 2^60 units and at least half of that.
  EXPECT_TRUE(fits(1, 0x1p-59));
  EXPECT_FALSE(fits(1, 0x1p-60));
  EXPECT_TRUE(fits(1, 1 + 0x1p-52));
  EXPECT_FALSE(fits(1, 0x1p-59 + 0x1p-70));
  EXPECT_TRUE(fits(kMax, -kMax));
  EXPECT_FALSE(fits(kMax, 1));
  EXPECT_FALSE(fits(kMax, kDenormal)) << "what underflows is not zero";
  EXPECT_FALSE(fits(1, kDenormal));
  EXPECT_TRUE(fits(kDenormal, 0x1p-1020)) << "denormals are multiples of the smallest";
  EXPECT_TRUE(fits(3 * kDenormal, -kDenormal));
  EXPECT_TRUE(fits(0x1p-950, 0x1p-1009));
  EXPECT_FALSE(fits(0x1p-950, 0x1p-1010));
  EXPECT_TRUE(fits(-0.0, 0));
}

double coordinate_of_kind(int kind, RandomSource& source) {
  switch (kind) {
    case 0:
      return source.uniform(-1, 1);
    case 1:
      return source.integer(-2, 2);
    case 2:
      return 1e15 + source.integer(-4, 4) * 0.125;
    case 3:
      return source.uniform_at_scale(-1, 1, -7, 0);
    case 4:
      return kDenormal * source.integer(-9, 9);
    case 5:
      return kMax / 2 * source.integer(-2, 2);
    default:  // all sixty bits, at the limit of every product and sum
    {
      const double sign = source.integer(-1, 1);
      const double power = std::ldexp(sign, static_cast<int>(source.integer(0, 59)));
      return power * (source.integer(0, 1) != 0 ? 2 - 0x1p-52 : 1);
    }
  }
}

// Against integers of any length, which share no code with these.
TEST(FixedPoint, OrientationsAgreeWithLongIntegers) {
  RandomSource source(1);
  for (int kind = 0; kind < 7; ++kind) {
    int held = 0;
    for (int n = 0; n < 3000; ++n) {
      Points points;
      for (double(&point)[3] : points.p) {
        for (double& x : point)
          x = coordinate_of_kind(kind, source);
      }
      if (n % 3 == 0) {
        for (int k = 0; k < 3; ++k)
          points.p[3][k] = points.p[n % 2][k];
      }
      FixedPoint fixed[4];
      if (!points.to_fixed(fixed)) continue;
      ++held;
      const auto& p = points.p;
      ASSERT_EQ(orientation_3d(fixed[0], fixed[1], fixed[2], fixed[3]),
                orientation_3d_big(p[0], p[1], p[2], p[3]))
          << kind;
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(orientation_2d(project(fixed[0], axis), project(fixed[1], axis),
                                 project(fixed[3], axis)),
                  orientation_2d_big(project(p[0], axis), project(p[1], axis), project(p[3], axis)))
            << kind;
      }
    }
    EXPECT_GT(held, kind == 6 ? 100 : 1500) << kind;
  }
}

// The largest differences in every product: sums of three may not overflow.
TEST(FixedPoint, TheLargestDifferencesDoNotOverflow) {
  const double top = 0x1p60 - 128;  // the largest double below 2^60
  for (int signs = 0; signs < 4096; ++signs) {
    Points points;
    for (int i = 0; i < 12; ++i)
      points.p[i / 3][i % 3] = (signs >> i & 1) != 0 ? top : -top;
    FixedPoint fixed[4];
    ASSERT_TRUE(points.to_fixed(fixed));
    const auto& p = points.p;
    ASSERT_EQ(orientation_3d(fixed[0], fixed[1], fixed[2], fixed[3]),
              orientation_3d_big(p[0], p[1], p[2], p[3]));
  }
}

}  // namespace
}  // namespace graze::narrowphase

#include <graze/narrowphase/predicates/orientation_stages.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "tests/shapes/random_source.h"

namespace graze::narrowphase {
namespace {

using Point3 = std::array<double, 3>;

constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kDenormal = std::numeric_limits<double>::denorm_min();

TEST(Orientation, HasTheSignsThatItsNameSays) {
  EXPECT_EQ(orientation_2d({0, 0}, {1, 0}, {0, 1}), Sign::Positive);
  EXPECT_EQ(orientation_2d({0, 0}, {0, 1}, {1, 0}), Sign::Negative);
  EXPECT_EQ(orientation_2d({0, 0}, {1, 1}, {3, 3}), Sign::Zero);
  const Point3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(orientation_3d(o.data(), x.data(), y.data(), z.data()), Sign::Positive);
  EXPECT_EQ(orientation_3d(o.data(), y.data(), x.data(), z.data()), Sign::Negative);
}

TEST(Orientation, ProjectionsKeepTheComponentsOfTheNormal) {
  // The normal of this triangle is (1, 2, 4) up to scale: all three projections turn left.
  const Point3 a{0, 0, 1}, b{4, 0, 0}, c{0, 2, 0};
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(
        orientation_2d(project(a.data(), axis), project(b.data(), axis), project(c.data(), axis)),
        Sign::Positive);
  }
}

/// Coordinates of one kind; four points of them are near one plane, or in it, half of the time.
Point3 point_of_kind(int kind, RandomSource& source) {
  Point3 p;
  for (double& x : p) {
    switch (kind) {
      case 0:
        x = source.uniform(-1, 1);
        break;
      case 1:
        x = source.integer(-2, 2);
        break;
      case 2:
        x = 1e15 + source.integer(-4, 4) * 0.125;
        break;
      case 3:
        x = source.uniform_at_scale(-1, 1, -40, 40);
        break;
      case 4:
        x = source.uniform_at_scale(-1, 1, -1070, 1020);
        break;
      case 5:
        x = kDenormal * source.integer(-9, 9);
        break;
      case 6:
        x = kMax * source.integer(-2, 2) / 2;
        break;
      default:
        x = source.integer(0, 1) != 0 ? source.uniform(-1, 1) : kDenormal * source.integer(-3, 3);
    }
  }
  return p;
}

constexpr int kKinds = 8;

// Independent stages: expansions of doubles against integers, rounding against both.
TEST(OrientationStages, Agree) {
  RandomSource source(1);
  for (int kind = 0; kind < kKinds; ++kind) {
    int expansions = 0;
    for (int n = 0; n < 3000; ++n) {
      Point3 p[4];
      for (Point3& point : p)
        point = point_of_kind(kind, source);
      if (n % 3 == 0) p[3] = p[n % 2];
      if (n % 3 == 1) {
        for (int k = 0; k < 3; ++k)
          p[3][k] = 0.5 * p[0][k] + 0.5 * p[1][k];  // in the plane, or nearly
      }
      const Sign big = orientation_3d_big(p[0].data(), p[1].data(), p[2].data(), p[3].data());
      const auto exact =
          orientation_3d_expansion(p[0].data(), p[1].data(), p[2].data(), p[3].data());
      const auto rounded =
          orientation_3d_filter(p[0].data(), p[1].data(), p[2].data(), p[3].data());
      ASSERT_EQ(exact.value_or(big), big) << kind;
      ASSERT_EQ(rounded.value_or(big), big) << kind;
      ASSERT_EQ(orientation_3d(p[1].data(), p[0].data(), p[2].data(), p[3].data()), -big) << kind;
      expansions += exact.has_value();
      const Point2 q[3] = {project(p[0].data(), 0), project(p[1].data(), 1),
                           project(p[3].data(), 2)};
      const Sign big_2d = orientation_2d_big(q[0], q[1], q[2]);
      ASSERT_EQ(orientation_2d_expansion(q[0], q[1], q[2]).value_or(big_2d), big_2d) << kind;
      ASSERT_EQ(orientation_2d_filter(q[0], q[1], q[2]).value_or(big_2d), big_2d) << kind;
    }
    // Which stage answers: expansions for all ordinary kinds, never where they could fail.
    if (kind <= 3) {
      EXPECT_EQ(expansions, 3000) << kind;
    }
    if (kind == 5 || kind == 6) {
      EXPECT_LT(expansions, 300) << kind;
    }
  }
}

TEST(OrientationStages, TheFilterDecidesGenericInput) {
  RandomSource source(2);
  int decided_3d = 0, decided_2d = 0;
  for (int n = 0; n < 10000; ++n) {
    Point3 p[4];
    for (Point3& point : p)
      point = point_of_kind(0, source);
    decided_3d +=
        orientation_3d_filter(p[0].data(), p[1].data(), p[2].data(), p[3].data()).has_value();
    decided_2d += orientation_2d_filter(project(p[0].data(), 0), project(p[1].data(), 0),
                                        project(p[2].data(), 0))
                      .has_value();
  }
  EXPECT_EQ(decided_3d, 10000);
  EXPECT_EQ(decided_2d, 10000);
}

TEST(OrientationStages, TheFilterIsUnsureWithinItsBound) {
  const Point3 a{0.1, 0.2, 0.3}, b{0.7, 0.1, 0.4}, c{0.2, 0.8, 0.9};
  Point3 d;
  for (int k = 0; k < 3; ++k)
    d[k] = (a[k] + b[k] + c[k]) / 3;
  EXPECT_FALSE(orientation_3d_filter(a.data(), b.data(), c.data(), d.data()).has_value());
  EXPECT_FALSE(orientation_2d_filter({0.1, 0.1}, {0.3, 0.3}, {0.7, 0.7}).value_or(Sign::Zero) !=
               Sign::Zero);
}

// A few units in the last place inside the bound and outside, so that neither it nor the size that
// it is multiplied by can shrink or grow unseen. The determinants here are exact.
TEST(OrientationStages, TheFilterKnowsItsBoundToAFewUlps) {
  constexpr double u = 0x1p-53;
  for (const double sign : {-1.0, 1.0}) {
    const auto filtered_2d = [&](double area) {  // products of 1 + area and of 1
      return orientation_2d_filter({0, 0}, {1, 1}, {1, 1 + sign * area});
    };
    EXPECT_FALSE(filtered_2d(8 * u).has_value());
    EXPECT_EQ(filtered_2d(12 * u), sign > 0 ? Sign::Positive : Sign::Negative);
    const auto filtered_3d = [&](double volume) {  // in a box of 1 by 1 by 1 + volume
      const Point3 a{0, 0, 0}, b{1, 0, 1}, c{0, 1, 0}, d{1, 0, 1 + sign * volume};
      return orientation_3d_filter(a.data(), b.data(), c.data(), d.data());
    };
    EXPECT_FALSE(filtered_3d(48 * u).has_value());
    EXPECT_EQ(filtered_3d(52 * u), sign > 0 ? Sign::Positive : Sign::Negative);
  }
}

// Right angles with legs of powers of two: the products are known, and so is where the filter's
// range ends.
TEST(OrientationStages, TheFilterIsUnsureWhereProductsMayUnderflowOrOverflow) {
  const auto filtered_2d = [](int x, int y) {
    return orientation_2d_filter({0, 0}, {std::ldexp(1.0, x), 0}, {0, std::ldexp(1.0, y)});
  };
  EXPECT_EQ(filtered_2d(-499, -499), Sign::Positive);
  EXPECT_EQ(filtered_2d(499, 499), Sign::Positive);
  EXPECT_FALSE(filtered_2d(-501, -501).has_value());
  EXPECT_FALSE(filtered_2d(501, 501).has_value());
  const auto filtered_3d = [](int x, int y, int z) {
    const Point3 a{0, 0, 0}, b{std::ldexp(1.0, x), 0, 0}, c{0, std::ldexp(1.0, y), 0},
        d{0, 0, std::ldexp(1.0, z)};
    return orientation_3d_filter(a.data(), b.data(), c.data(), d.data());
  };
  EXPECT_EQ(filtered_3d(10, -499, -499), Sign::Positive);
  EXPECT_EQ(filtered_3d(-10, 499, 499), Sign::Positive);
  EXPECT_FALSE(filtered_3d(10, -501, -501).has_value()) << "y z underflows";
  EXPECT_FALSE(filtered_3d(-10, 501, 501).has_value()) << "y z overflows";
  EXPECT_FALSE(filtered_3d(-10, -498, -498).has_value()) << "x y z underflows";
  EXPECT_FALSE(filtered_3d(10, 498, 498).has_value()) << "x y z overflows";
}

// Inner products that overflow to infinities of either sign, beside an x that hides it.
TEST(OrientationStages, OverflowIsNeverAnAnswer) {
  const double y = 0x1p513, x = 0x1p-600;
  const Point3 a{0, 0, 0}, b{x, y, y}, c{x, -y, y}, d{0, y, 2 * y};
  const Sign big = orientation_3d_big(a.data(), b.data(), c.data(), d.data());
  EXPECT_EQ(orientation_3d(a.data(), b.data(), c.data(), d.data()), big);
  EXPECT_EQ(orientation_3d_filter(a.data(), b.data(), c.data(), d.data()).value_or(big), big);
}

TEST(OrientationStages, AxisAlignedPlanesAreCertifiedWithoutExactArithmetic) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto in_plane = [&](double p, double q) {
      Point3 point{p, p, p};
      point[axis] = 5;
      point[(axis + 1) % 3] = q;
      return point;
    };
    const Point3 a = in_plane(0.1, 0.2), b = in_plane(0.7, 0.1), c = in_plane(0.2, 0.8),
                 d = in_plane(0.3, 0.3);
    EXPECT_EQ(orientation_3d_filter(a.data(), b.data(), c.data(), d.data()), Sign::Zero) << axis;
  }
  EXPECT_EQ(orientation_2d_filter({0.1, 5}, {0.7, 5}, {0.2, 5}), Sign::Zero);
  EXPECT_EQ(orientation_2d_filter({5, 0.1}, {5, 0.7}, {5, 0.2}), Sign::Zero);
}

// Denormal numbers have their unit's exponent, not one less: b is half of c.
TEST(OrientationStages, DenormalAndNormalNumbersHaveOneUnit) {
  const double x = std::ldexp(1.0, -1022);
  EXPECT_EQ(orientation_2d_big({0, 0}, {x, x / 2}, {2 * x, x}), Sign::Zero);
  EXPECT_EQ(orientation_2d_big({0, 0}, {x, x / 2}, {2 * x, x + kDenormal}), Sign::Positive);
}

// One step of the smallest double beside the largest: nothing but integers can see it.
TEST(OrientationStages, IntegersSeeTheSmallestStep) {
  const Point3 a{-kMax, -kMax, 0}, b{kMax, -kMax, 0}, c{0, kMax, 0}, d{0, 0, kDenormal},
      e{0, 0, -kDenormal};
  EXPECT_EQ(orientation_3d(a.data(), b.data(), c.data(), d.data()), Sign::Positive);
  EXPECT_EQ(orientation_3d(a.data(), b.data(), c.data(), e.data()), Sign::Negative);
  EXPECT_EQ(orientation_2d({-kMax, -kMax}, {kMax, kMax}, {0, kDenormal}), Sign::Positive);
  EXPECT_EQ(orientation_2d({-kMax, -kMax}, {kMax, kMax}, {kDenormal, kDenormal}), Sign::Zero);
}

}  // namespace
}  // namespace graze::narrowphase

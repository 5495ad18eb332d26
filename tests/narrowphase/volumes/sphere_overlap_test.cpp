#include <graze/bvh/error.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>
#include <graze/narrowphase/volumes/spheres/sphere_stages.h>
#include <gtest/gtest.h>

#include "tests/narrowphase/volumes/rational_spheres.h"
#include "tests/narrowphase/volumes/volume_source.h"

namespace graze {
namespace {

using narrowphase::Decision;
using narrowphase::Stage;

TEST(Law2Spheres, AgreeWithRationalsOnEveryKindOfNumber) {
  for (Numbers kind : kEveryKind) {
    VolumeSource source(kind, 1);
    int hits = 0;
    for (int n = 0; n < 4000; ++n) {
      const Sphere a = source.sphere(), b = source.sphere();
      const bool expected = oracle::overlap(a, b);
      hits += expected;
      ASSERT_EQ(intersects(a, b), expected) << static_cast<int>(kind) << ", " << n;
      ASSERT_EQ(intersects(b, a), expected) << "law 4";
      const bool is_inside = oracle::overlap(a, Sphere{b.centre, 0});
      ASSERT_EQ(contains(a, b.centre), is_inside);
    }
    EXPECT_GT(hits, 100) << static_cast<int>(kind);
    EXPECT_LT(hits, 3900) << static_cast<int>(kind);
  }
}

TEST(Law2Spheres, TouchingCountsToTheLastBit) {
  VolumeSource source(Numbers::Lattice, 2);
  for (int n = 0; n < 3000; ++n) {
    const Quadruple q = source.quadruple();
    // Every other pair where squares are about the smallest double.
    const double exponent =
        n % 2 == 0 ? source.random().integer(-1070, 1010) : source.random().integer(-545, -525);
    const double scale = std::ldexp(1.0, static_cast<int>(exponent));
    const double part = source.random().integer(0, static_cast<int>(q.length) - 1);
    const Eigen::Vector3d centre = source.point();
    const Sphere a{centre * scale, (q.length - part) * scale};
    const Sphere b{(centre + q.way) * scale, part * scale};
    const Decision touching = narrowphase::decide(a, b);
    ASSERT_TRUE(touching.is_hit) << n;
    ASSERT_EQ(touching.stage, Stage::Exact) << n;
    const Sphere smaller{a.centre, next_below(a.radius)};
    ASSERT_EQ(intersects(smaller, b), oracle::overlap(smaller, b));
    ASSERT_FALSE(intersects(smaller, b)) << n;
    ASSERT_TRUE(intersects(Sphere{a.centre, next_above(a.radius)}, b)) << n;
    const Sphere whole{a.centre, q.length * scale};
    ASSERT_TRUE(contains(whole, b.centre));
    ASSERT_EQ(narrowphase::decide_contains(whole, b.centre).stage, Stage::Exact);
    ASSERT_FALSE(contains(Sphere{whole.centre, next_below(whole.radius)}, b.centre));
  }
}

// The sum of the radii is not a double here: rounding it would lose the question.
TEST(Law2Spheres, RadiiWhoseSumIsNoDouble) {
  const Sphere tiny{{3, 0, 0}, 0x1p-80};
  EXPECT_TRUE(intersects(Sphere{{0, 0, 0}, 3}, tiny));
  EXPECT_FALSE(intersects(Sphere{{0, 0, 0}, next_below(3)}, tiny));
  EXPECT_TRUE(intersects(Sphere{{0, 0, 0}, 0x1p-60}, Sphere{{1, 0, 0}, 1}));
  const double huge = 0x1.fffffffffffffp1023;
  EXPECT_TRUE(intersects(Sphere{{-huge, 0, 0}, huge}, Sphere{{huge, 0, 0}, huge}));
  EXPECT_FALSE(intersects(Sphere{{-huge, 0, 0}, huge}, Sphere{{huge, 0, 0}, next_below(huge)}));
}

TEST(Law6Spheres, GenericPairsAreDecidedWithoutExactArithmetic) {
  VolumeSource source(Numbers::Generic, 3);
  for (int n = 0; n < 20000; ++n) {
    const Sphere a = source.sphere(), b = source.sphere();
    ASSERT_EQ(narrowphase::decide(a, b).stage, Stage::Triage) << n;
    ASSERT_EQ(narrowphase::decide_contains(a, b.centre).stage, Stage::Triage) << n;
  }
}

TEST(Law10Spheres, BadValuesAreRefused) {
  const Sphere good{{0, 0, 0}, 1};
  for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (int i = 0; i < 4; ++i) {
      Sphere broken = good;
      (i < 3 ? broken.centre[i] : broken.radius) = bad;
      EXPECT_THROW(intersects(good, broken), InputError) << i;
      EXPECT_THROW(intersects(broken, good), InputError) << i;
      EXPECT_THROW(contains(broken, Eigen::Vector3d(0, 0, 0)), InputError) << i;
    }
    EXPECT_THROW(contains(good, Eigen::Vector3d(0, bad, 0)), InputError);
  }
  EXPECT_THROW(intersects(good, Sphere{{0, 0, 0}, -1}), InputError);
  try {
    contains(good, Eigen::Vector3d(0, std::nan(""), 0));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "point: coordinate y is not finite");
  }
}

}  // namespace
}  // namespace graze

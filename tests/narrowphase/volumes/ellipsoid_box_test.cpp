#include <graze/bvh/error.h>
#include <graze/narrowphase/volumes/ellipsoid_box.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/spheres/sphere_stages.h>
#include <gtest/gtest.h>

#include "tests/narrowphase/volumes/rational_spheres.h"
#include "tests/narrowphase/volumes/volume_source.h"

namespace graze {
namespace {

using narrowphase::Decision;
using narrowphase::Stage;

Ellipsoid ellipsoid_from(VolumeSource& source) {
  const Eigen::Vector3d centre = source.point();
  return {centre, source.point().cwiseAbs()};
}

TEST(Law2Ellipsoid, AgreesWithRationalsOnEveryKindOfNumber) {
  for (Numbers kind : kEveryKind) {
    VolumeSource source(kind, 1);
    int hits = 0;
    for (int n = 0; n < 4000; ++n) {
      const Ellipsoid ellipsoid = ellipsoid_from(source);
      const Aabb box = source.box();
      const bool expected = oracle::overlap(ellipsoid, box);
      hits += expected;
      ASSERT_EQ(intersects(ellipsoid, box), expected) << static_cast<int>(kind) << ", " << n;
      ASSERT_EQ(intersects(box, ellipsoid), expected) << "law 4";
    }
    EXPECT_GT(hits, 100) << static_cast<int>(kind);
    EXPECT_LT(hits, 3900) << static_cast<int>(kind);
  }
}

// A point (x, y, z) / d of the unit sphere, with integers x, y, z, d, stretched by multiples of d.
TEST(Law2Ellipsoid, TouchingCountsToTheLastBit) {
  VolumeSource source(Numbers::Lattice, 2);
  for (int n = 0; n < 2000; ++n) {
    const Quadruple q = source.quadruple();
    const double scale = std::ldexp(1.0, static_cast<int>(source.random().integer(-900, 900)));
    const Eigen::Vector3d centre = source.point() * scale;
    Eigen::Vector3d semi_axes, corner, far;
    for (int i = 0; i < 3; ++i) {
      const double stretch = source.random().integer(1, 1000) * scale;
      semi_axes[i] = q.length * stretch;
      corner[i] = centre[i] + q.way[i] * stretch;
      far[i] = corner[i] + q.way[i] * scale;
    }
    const Aabb box{corner.cwiseMin(far), corner.cwiseMax(far)};
    const Decision touching = narrowphase::decide(Ellipsoid{centre, semi_axes}, box);
    ASSERT_TRUE(touching.is_hit) << n;
    ASSERT_EQ(touching.stage, Stage::Exact) << n;
    for (int i = 0; i < 3; ++i) {
      Eigen::Vector3d smaller = semi_axes, larger = semi_axes;
      smaller[i] = next_below(smaller[i]);
      larger[i] = next_above(larger[i]);
      ASSERT_EQ(intersects(Ellipsoid{centre, smaller}, box), q.way[i] == 0) << n;
      ASSERT_TRUE(intersects(Ellipsoid{centre, larger}, box)) << n;
    }
  }
}

TEST(Law2Ellipsoid, EqualAxesAreASphere) {
  VolumeSource source(Numbers::Lattice, 3);
  for (int n = 0; n < 3000; ++n) {
    const Sphere sphere = source.sphere();
    const Aabb box = source.box();
    const Ellipsoid ellipsoid{sphere.centre, Eigen::Vector3d::Constant(sphere.radius)};
    ASSERT_EQ(intersects(ellipsoid, box), intersects(sphere, box)) << n;
  }
}

TEST(Law2Ellipsoid, FlatOnes) {
  const Ellipsoid disc{{0, 0, 0}, {5, 5, 0}};
  EXPECT_TRUE(intersects(disc, Aabb{{3, 4, -1}, {9, 9, 1}}));
  EXPECT_TRUE(intersects(disc, Aabb{{3, 4, 0}, {9, 9, 1}}));
  EXPECT_FALSE(intersects(disc, Aabb{{3, next_above(4), -1}, {9, 9, 1}}));
  EXPECT_FALSE(intersects(disc, Aabb{{0, 0, 0x1p-1074}, {9, 9, 1}}));
  const Ellipsoid point{{1, 2, 3}, {0, 0, 0}};
  EXPECT_TRUE(intersects(point, Aabb{{1, 2, 3}, {1, 2, 3}}));
  EXPECT_FALSE(intersects(point, Aabb{{1, 2, next_above(3)}, {1, 2, 4}}));
}

TEST(Law6Ellipsoid, GenericPairsAreDecidedWithoutExactArithmetic) {
  VolumeSource source(Numbers::Generic, 4);
  for (int n = 0; n < 20000; ++n) {
    const Ellipsoid ellipsoid = ellipsoid_from(source);
    ASSERT_EQ(narrowphase::decide(ellipsoid, source.box()).stage, Stage::Triage) << n;
  }
}

TEST(Law10Ellipsoid, BadValuesAreRefused) {
  const Ellipsoid good{{0, 0, 0}, {1, 1, 1}};
  const Aabb unit{{0, 0, 0}, {1, 1, 1}};
  for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, -1.0}) {
    for (int i = 0; i < 6; ++i) {
      Ellipsoid broken = good;
      (i < 3 ? broken.centre : broken.semi_axes)[i % 3] = bad;
      if (i < 3 && bad == -1) continue;
      EXPECT_THROW(intersects(broken, unit), InputError) << i;
      EXPECT_THROW(intersects(unit, broken), InputError) << i;
    }
  }
  EXPECT_THROW(intersects(good, Aabb{{0, 0, 0}, {1, -1, 1}}), InputError);
  try {
    intersects(Ellipsoid{{0, 0, 0}, {1, -1, 1}}, unit);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "ellipsoid: semi-axis y is negative or not finite");
  }
}

}  // namespace
}  // namespace graze

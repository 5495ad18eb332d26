#include <graze/bvh/error.h>
#include <graze/narrowphase/volumes/hollow_overlap.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/spheres/sphere_stages.h>
#include <gtest/gtest.h>

#include "tests/narrowphase/volumes/rational_spheres.h"
#include "tests/narrowphase/volumes/volume_source.h"

namespace graze {
namespace {

using narrowphase::decide;
using narrowphase::Stage;

void expect_oracle(const Sphere& sphere, const Aabb& box) {
  const HollowSphere hollow{sphere};
  const HollowAabb surface{box};
  ASSERT_EQ(intersects(sphere, surface), oracle::overlap(sphere, surface));
  ASSERT_EQ(intersects(surface, sphere), oracle::overlap(sphere, surface)) << "law 4";
  ASSERT_EQ(intersects(hollow, box), oracle::overlap(hollow, box));
  ASSERT_EQ(intersects(box, hollow), oracle::overlap(hollow, box)) << "law 4";
  ASSERT_EQ(intersects(hollow, surface), oracle::overlap(hollow, surface));
  ASSERT_EQ(intersects(surface, hollow), oracle::overlap(hollow, surface)) << "law 4";
}

TEST(Law2Hollow, AgreeWithRationalsOnEveryKindOfNumber) {
  for (Numbers kind : kEveryKind) {
    VolumeSource source(kind, 1);
    int differ = 0;
    for (int n = 0; n < 1200; ++n) {
      Sphere sphere = source.sphere();
      const Aabb box = source.box();
      // In every other box's middle, where hollow or not matters.
      if (n % 2 == 1) sphere.centre = 0.5 * box.min + 0.5 * box.max;
      ASSERT_NO_FATAL_FAILURE(expect_oracle(sphere, box)) << static_cast<int>(kind) << ", " << n;
      sphere.radius *= 0.25;
      ASSERT_NO_FATAL_FAILURE(expect_oracle(sphere, box)) << static_cast<int>(kind) << ", " << n;
      differ += intersects(sphere, box) != intersects(HollowSphere{sphere}, HollowAabb{box});
    }
    EXPECT_GT(differ, 50) << static_cast<int>(kind) << ": hollow or not should matter";
  }
}

const Aabb kBox{{-10, -20, -30}, {10, 20, 30}};

TEST(Law2Hollow, ABallInsideTouchesTheNearestFaceToTheLastBit) {
  const HollowAabb surface{kBox};
  const auto ball = [](double radius) { return Sphere{{3, 4, 5}, radius}; };
  EXPECT_TRUE(intersects(ball(7), surface));
  EXPECT_EQ(decide(ball(7), surface).stage, Stage::Exact);
  EXPECT_FALSE(intersects(ball(next_below(7)), surface));
  EXPECT_EQ(decide(ball(next_below(7)), surface).stage, Stage::Triage) << "rounding is monotone";
  EXPECT_TRUE(intersects(HollowSphere{ball(7)}, surface));
  EXPECT_FALSE(intersects(HollowSphere{ball(next_below(7))}, surface));
  EXPECT_TRUE(intersects(ball(0), kBox)) << "solid";
}

// 1 - 2^-60 rounds to 1: only the exact stage sees that the face is nearer.
TEST(Law2Hollow, ADepthThatIsNoDouble) {
  const HollowAabb surface{{{0x1p-60, -8, -8}, {8, 8, 8}}};
  EXPECT_TRUE(intersects(Sphere{{1, 0, 0}, 1}, surface));
  EXPECT_FALSE(intersects(Sphere{{1, 0, 0}, next_below(1)}, surface));
  EXPECT_FALSE(intersects(Sphere{{1, 0, 0}, 1}, HollowAabb{{{-0x1p-60, -8, -8}, {8, 8, 8}}}));
}

TEST(Law2Hollow, ASphereAroundABoxTouchesItsFarthestCornerToTheLastBit) {
  VolumeSource source(Numbers::Lattice, 2);
  for (int n = 0; n < 2000; ++n) {
    const Quadruple q = source.quadruple();
    const Eigen::Vector3d centre = source.point();
    const Eigen::Vector3d other = centre + q.way * (source.random().integer(-4, 4) / 4);
    const Eigen::Vector3d corner = centre + q.way;
    const Aabb box{corner.cwiseMin(other), corner.cwiseMax(other)};
    for (double radius : {q.length, next_below(q.length), next_above(q.length)}) {
      ASSERT_NO_FATAL_FAILURE(expect_oracle({centre, radius}, box)) << n;
    }
    ASSERT_TRUE(intersects(HollowSphere{{centre, q.length}}, box)) << n;
    ASSERT_TRUE(intersects(HollowSphere{{centre, q.length}}, HollowAabb{box})) << n;
    ASSERT_EQ(decide(HollowSphere{{centre, q.length}}, box).stage, Stage::Exact) << n;
    ASSERT_FALSE(intersects(HollowSphere{{centre, next_above(q.length)}}, box)) << n;
  }
}

TEST(Law2Hollow, AFlatBoxIsItsOwnSurface) {
  VolumeSource source(Numbers::Lattice, 3);
  for (int n = 0; n < 2000; ++n) {
    const Sphere sphere = source.sphere();
    Aabb box = source.box();
    box.max[n % 3] = box.min[n % 3];
    ASSERT_EQ(intersects(sphere, HollowAabb{box}), intersects(sphere, box)) << n;
    ASSERT_EQ(intersects(HollowSphere{sphere}, HollowAabb{box}),
              intersects(HollowSphere{sphere}, box))
        << n;
  }
}

TEST(Law6Hollow, GenericPairsAreDecidedWithoutExactArithmetic) {
  VolumeSource source(Numbers::Generic, 4);
  for (int n = 0; n < 10000; ++n) {
    const Sphere sphere = source.sphere();
    const Aabb box = source.box();
    ASSERT_EQ(decide(sphere, HollowAabb{box}).stage, Stage::Triage) << n;
    ASSERT_EQ(decide(HollowSphere{sphere}, box).stage, Stage::Triage) << n;
    ASSERT_EQ(decide(HollowSphere{sphere}, HollowAabb{box}).stage, Stage::Triage) << n;
  }
}

TEST(Law10Hollow, BadValuesAreRefused) {
  const Sphere good{{0, 0, 0}, 1};
  const Sphere bad{{0, 0, 0}, -1};
  const Aabb inverted{{0, 0, 0}, {1, -1, 1}};
  EXPECT_THROW(intersects(bad, HollowAabb{kBox}), InputError);
  EXPECT_THROW(intersects(HollowSphere{bad}, kBox), InputError);
  EXPECT_THROW(intersects(HollowSphere{bad}, HollowAabb{kBox}), InputError);
  EXPECT_THROW(intersects(good, HollowAabb{inverted}), InputError);
  EXPECT_THROW(intersects(HollowSphere{good}, inverted), InputError);
  EXPECT_THROW(intersects(HollowSphere{good}, HollowAabb{inverted}), InputError);
}

}  // namespace
}  // namespace graze

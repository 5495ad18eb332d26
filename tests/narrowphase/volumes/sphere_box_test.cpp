#include <graze/bvh/error.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/spheres/sphere_stages.h>
#include <gtest/gtest.h>

#include "tests/narrowphase/volumes/rational_spheres.h"
#include "tests/narrowphase/volumes/volume_source.h"

namespace graze {
namespace {

using narrowphase::decide_arvo;
using narrowphase::decide_branch_free;
using narrowphase::decide_quick_rejections;
using narrowphase::Decision;
using narrowphase::Stage;

void expect_all(const Sphere& sphere, const Aabb& box, bool expected) {
  ASSERT_EQ(decide_arvo(sphere, box).is_hit, expected);
  ASSERT_EQ(decide_quick_rejections(sphere, box).is_hit, expected);
  ASSERT_EQ(decide_branch_free(sphere, box).is_hit, expected);
  ASSERT_EQ(intersects(sphere, box), expected);
  ASSERT_EQ(intersects(box, sphere), expected) << "law 4";
}

TEST(Law2SphereBox, TheThreeMethodsAgreeWithRationals) {
  for (Numbers kind : kEveryKind) {
    VolumeSource source(kind, 1);
    int hits = 0;
    for (int n = 0; n < 4000; ++n) {
      const Sphere sphere = source.sphere();
      const Aabb box = source.box();
      const bool expected = oracle::overlap(sphere, box);
      hits += expected;
      ASSERT_NO_FATAL_FAILURE(expect_all(sphere, box, expected))
          << static_cast<int>(kind) << ", " << n;
    }
    EXPECT_GT(hits, 100) << static_cast<int>(kind);
    EXPECT_LT(hits, 3900) << static_cast<int>(kind);
  }
}

/// A box one of whose corners, the one nearest to the centre, is at `way` from it.
Aabb box_beyond(const Eigen::Vector3d& centre, const Eigen::Vector3d& way, double extent) {
  Aabb box;
  for (int i = 0; i < 3; ++i) {
    const double near = centre[i] + way[i];
    const double far = near + (way[i] < 0 ? -extent : extent);
    box.min[i] = std::min(near, far);
    box.max[i] = std::max(near, far);
  }
  return box;
}

TEST(Law2SphereBox, TouchingCountsToTheLastBit) {
  VolumeSource source(Numbers::Lattice, 2);
  for (int n = 0; n < 3000; ++n) {
    const Quadruple q = source.quadruple();
    const double scale = std::ldexp(1.0, static_cast<int>(source.random().integer(-1070, 1010)));
    const Eigen::Vector3d centre = source.point() * scale;
    const double extent = source.random().integer(0, 4) * scale;
    const Aabb box = box_beyond(centre, q.way * scale, extent);
    const double radius = q.length * scale;
    ASSERT_NO_FATAL_FAILURE(expect_all({centre, radius}, box, true)) << n;
    ASSERT_EQ(decide_arvo({centre, radius}, box).stage, Stage::Exact);
    ASSERT_EQ(decide_quick_rejections({centre, radius}, box).stage, Stage::Exact);
    ASSERT_EQ(decide_branch_free({centre, radius}, box).stage, Stage::Exact);
    ASSERT_NO_FATAL_FAILURE(expect_all({centre, next_below(radius)}, box, false)) << n;
    ASSERT_NO_FATAL_FAILURE(expect_all({centre, next_above(radius)}, box, true)) << n;
  }
}

TEST(Law6SphereBox, GenericPairsAreDecidedWithoutExactArithmetic) {
  VolumeSource source(Numbers::Generic, 3);
  for (int n = 0; n < 20000; ++n) {
    const Sphere sphere = source.sphere();
    const Aabb box = source.box();
    ASSERT_EQ(decide_arvo(sphere, box).stage, Stage::Triage) << n;
    ASSERT_EQ(decide_quick_rejections(sphere, box).stage, Stage::Triage) << n;
    ASSERT_EQ(decide_branch_free(sphere, box).stage, Stage::Triage) << n;
  }
}

Aabb local_box(const Obb& box) {
  return {-box.half_extents, box.half_extents};
}

TEST(Law3SphereBox, TheCentreGoesIntoTheFrameOfAnOrientedBox) {
  VolumeSource source(Numbers::Generic, 4);
  int hits = 0;
  for (int n = 0; n < 3000; ++n) {
    const Eigen::Vector3d axis = source.point().normalized();
    Obb box{Pose::Identity(), source.point().cwiseAbs()};
    box.pose.linear() = Eigen::AngleAxisd(source.coordinate() * 3, axis).toRotationMatrix();
    box.pose.translation() = source.point();
    const Sphere sphere = source.sphere();
    const Eigen::Vector3d q = sphere.centre - box.pose.translation();
    const auto r = box.pose.linear();
    Eigen::Vector3d local;
    for (int i = 0; i < 3; ++i)
      local[i] = (r(0, i) * q[0] + r(1, i) * q[1]) + r(2, i) * q[2];
    const bool expected = oracle::overlap(Sphere{local, sphere.radius}, local_box(box));
    hits += expected;
    ASSERT_EQ(intersects(sphere, box), expected) << n;
    ASSERT_EQ(intersects(box, sphere), expected) << n;
    // The radius at which the rounded centre touches, as near as doubles come, from both sides.
    const Eigen::Vector3d nearest = local.cwiseMax(local_box(box).min).cwiseMin(local_box(box).max);
    const double gap = (local - nearest).norm();
    for (double radius : {next_below(gap), gap, next_above(gap)}) {
      if (radius == HUGE_VAL || gap == 0) continue;
      const bool is_touching = oracle::overlap(Sphere{local, radius}, local_box(box));
      ASSERT_EQ(intersects(Sphere{sphere.centre, radius}, box), is_touching) << n;
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_LT(hits, 2900);
}

TEST(Law3SphereBox, AFrameWithoutRoundingIsTheAlignedTest) {
  VolumeSource source(Numbers::Lattice, 5);
  for (int n = 0; n < 3000; ++n) {
    Obb box{Pose::Identity(), source.point().cwiseAbs()};
    box.pose.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    box.pose.translation() = source.point();
    const Sphere sphere = source.sphere();
    const Eigen::Vector3d turned(box.half_extents[1], box.half_extents[0], box.half_extents[2]);
    const Eigen::Vector3d t = box.pose.translation();
    ASSERT_EQ(intersects(sphere, box), intersects(sphere, Aabb{t - turned, t + turned})) << n;
  }
}

TEST(Law10SphereBox, ACentreThatOverflowsInTheFrameOfTheBoxIsRefused) {
  Obb box{Pose::Identity(), {1, 1, 1}};
  box.pose.translation().y() = -1.5e308;
  try {
    intersects(Sphere{{0, 1.5e308, 0}, 1}, box);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "sphere in the frame of the box: coordinate x of the centre is not finite")
        << "infinity times the zeros of the rotation";
  }
}

TEST(Law10SphereBox, BadValuesAreRefused) {
  const Sphere good{{0, 0, 0}, 1};
  const Aabb unit{{0, 0, 0}, {1, 1, 1}};
  const Obb turned{Pose::Identity(), {1, 1, 1}};
  for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (int i = 0; i < 4; ++i) {
      Sphere broken = good;
      (i < 3 ? broken.centre[i] : broken.radius) = bad;
      EXPECT_THROW(intersects(broken, unit), InputError) << i;
      EXPECT_THROW(intersects(broken, turned), InputError) << i;
    }
    for (int i = 0; i < 6; ++i) {
      Aabb broken = unit;
      (i < 3 ? broken.min : broken.max)[i % 3] = bad;
      EXPECT_THROW(intersects(good, broken), InputError) << i;
      EXPECT_THROW(intersects(broken, good), InputError) << i;
    }
    EXPECT_THROW(intersects(good, Obb{Pose::Identity(), {1, bad, 1}}), InputError);
  }
  EXPECT_THROW(intersects(Sphere{{0, 0, 0}, -1}, unit), InputError);
  EXPECT_THROW(intersects(good, Aabb{{0, 0, 0}, {1, -1, 1}}), InputError);
  Obb skewed = turned;
  skewed.pose.linear()(0, 1) = 0.1;
  EXPECT_THROW(intersects(good, skewed), PoseError);
}

}  // namespace
}  // namespace graze

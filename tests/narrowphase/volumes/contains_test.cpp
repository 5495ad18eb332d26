#include <gmpxx.h>
#include <graze/bvh/error.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/volumes/contains.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/narrowphase/volumes/obb_cases.h"
#include "tests/narrowphase/volumes/volume_source.h"

namespace graze {
namespace {

constexpr double kHuge = std::numeric_limits<double>::max();

bool contains_exactly(const KDop<18>& kdop, const Eigen::Vector3d& point) {
  for (std::size_t slab = 0; slab < KDop<18>::kSlabs; ++slab) {
    mpq_class sum = 0;
    for (int i = 0; i < 3; ++i)
      sum += kKDopDirections<18>[slab][static_cast<std::size_t>(i)] * mpq_class(point[i]);
    if (sum < mpq_class(kdop.min[slab]) || sum > mpq_class(kdop.max[slab])) return false;
  }
  return true;
}

/// Slabs whose bounds are the rounded sums of the point, or a step beyond: the exact sum is often
/// on the wrong side of these.
KDop<18> tight_about(const Eigen::Vector3d& point, RandomSource& random) {
  KDop<18> kdop;
  for (std::size_t slab = 0; slab < KDop<18>::kSlabs; ++slab) {
    double sum = 0;
    for (int i = 0; i < 3; ++i)
      sum += kKDopDirections<18>[slab][static_cast<std::size_t>(i)] * point[i];
    sum = std::fmin(std::fmax(sum, -kHuge), kHuge);
    kdop.min[slab] = kdop.max[slab] = sum;
    if (random.integer(0, 9) < 5)
      kdop.min[slab] = std::fmax(std::nextafter(sum, -HUGE_VAL), -kHuge);
    if (random.integer(0, 9) < 5) kdop.max[slab] = std::fmin(std::nextafter(sum, HUGE_VAL), kHuge);
  }
  return kdop;
}

TEST(Law11ContainsKDop, ExactForAllNumbers) {
  int inside = 0, outside = 0;
  for (Numbers kind : kEveryKind) {
    VolumeSource source(kind, 1);
    for (int n = 0; n < 6000; ++n) {
      const Eigen::Vector3d point = source.point();
      const KDop<18> kdop = tight_about(point, source.random());
      const bool is_inside = contains_exactly(kdop, point);
      ASSERT_EQ(contains(kdop, point), is_inside) << n;
      (is_inside ? inside : outside) += 1;
    }
  }
  EXPECT_GT(inside, 3000);
  EXPECT_GT(outside, 3000);
}

TEST(Law11ContainsKDop, SumsThatRoundOrOverflow) {
  KDop<18> all;
  all.min.fill(-kHuge);
  all.max.fill(kHuge);
  EXPECT_TRUE(contains(all, {1, 2, 3}));
  EXPECT_TRUE(contains(all, {kHuge, 0, 0}));
  EXPECT_FALSE(contains(all, {kHuge, 0x1p-1074, 0})) << "the sum rounds to the bound";
  EXPECT_FALSE(contains(all, {kHuge, kHuge, 0})) << "the sum overflows";
  EXPECT_FALSE(contains(all, {-kHuge, 0, 0x1p-1074}))
      << "the difference of x and z is below the minimum";
  KDop<18> one = all;
  one.max[3] = 1;  // x + y <= 1
  EXPECT_TRUE(contains(one, {1, 0, 0}));
  EXPECT_TRUE(contains(one, {1, -0x1p-1074, 0}));
  EXPECT_FALSE(contains(one, {1, 0x1p-1074, 0}));
  EXPECT_FALSE(contains(one, {0x1p-1074, 1, 0}));
}

TEST(Law11ContainsAabb, ClosedInEachCoordinate) {
  const Aabb box{{-1, 0, 2}, {1, 0, 3}};
  EXPECT_TRUE(contains(box, Eigen::Vector3d(1, 0, 2)));
  EXPECT_TRUE(contains(box, Eigen::Vector3d(0, -0.0, 2.5)));
  EXPECT_FALSE(contains(box, Eigen::Vector3d(0, 0x1p-1074, 2.5)));
  EXPECT_FALSE(contains(box, Eigen::Vector3d(std::nextafter(1.0, 2.0), 0, 2)));
  EXPECT_FALSE(contains(box, Eigen::Vector3d(0, 0, std::nextafter(2.0, 1.0))));
}

TEST(Law11ContainsAabb, ABoxIsInsideWithItsCorners) {
  VolumeSource source(Numbers::Lattice, 3);
  int inside = 0;
  for (int n = 0; n < 20000; ++n) {
    const Aabb outer = source.box(), inner = source.box();
    const bool is_inside = contains(outer, inner);
    ASSERT_EQ(is_inside, contains(outer, inner.min) && contains(outer, inner.max));
    ASSERT_TRUE(contains(outer, outer));
    inside += is_inside;
  }
  EXPECT_GT(inside, 100);
  EXPECT_LT(inside, 10000);
}

// A point is a triangle without size, of which law 3 says where it goes.
TEST(Law3ContainsObb, AgreesWithTheTriangleTest) {
  RandomSource random(4);
  int inside = 0;
  for (int n = 0; n < 20000; ++n) {
    const Obb box = random_case(kEveryLie[static_cast<std::size_t>(n) % kLies], random).a;
    const Eigen::Vector3d local = box.half_extents.cwiseProduct(random.lattice_point(-2, 2));
    const Eigen::Vector3d point = box.pose * local;
    const bool is_inside = contains(box, point);
    ASSERT_EQ(is_inside, intersects(Triangle{point, point, point}, box)) << n;
    inside += is_inside;
  }
  EXPECT_GT(inside, 1000);
  EXPECT_LT(inside, 19000);
}

TEST(Law10Contains, BadVolumesAndPointsAreRefused) {
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  const Obb oriented{Pose::Identity(), {1, 1, 1}};
  KDop<18> kdop;
  kdop.min.fill(-1);
  kdop.max.fill(1);
  for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (int i = 0; i < 3; ++i) {
      Eigen::Vector3d point(0, 0, 0);
      point[i] = bad;
      EXPECT_THROW(contains(box, point), InputError);
      EXPECT_THROW(contains(oriented, point), InputError);
      EXPECT_THROW(contains(kdop, point), InputError);
    }
  }
  const Eigen::Vector3d origin(0, 0, 0);
  const Aabb inverted{{0, 0, 1}, {1, 1, 0}};
  EXPECT_THROW(contains(inverted, origin), InputError);
  EXPECT_THROW(contains(inverted, box), InputError);
  EXPECT_THROW(contains(box, inverted), InputError);
  Obb loose = oriented, negative = oriented;
  loose.pose.linear() *= 2;
  negative.half_extents.x() = -1;
  EXPECT_THROW(contains(loose, origin), PoseError);
  EXPECT_THROW(contains(negative, origin), InputError);
  kdop.max[4] = -2;
  EXPECT_THROW(contains(kdop, origin), InputError);
  Obb far = oriented;
  far.pose.translation().x() = -kHuge;
  EXPECT_THROW(contains(far, Eigen::Vector3d(kHuge, 0, 0)), InputError) << "overflows on its way";
}

}  // namespace
}  // namespace graze

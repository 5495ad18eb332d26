// The volume around two volumes contains both, in rational arithmetic, and is not much too large.

#include <graze/bvh/error.h>
#include <graze/bvh/fit/aabb_fit.h>
#include <graze/bvh/fit/kdop_fit.h>
#include <graze/bvh/fit/obb_fit.h>
#include <graze/bvh/fit/sphere_fit.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/bvh/fit/point_sets.h"
#include "tests/bvh/fit/rational_containment.h"
#include "tests/shapes/random_meshes.h"

namespace graze::tests {
namespace {

/// |ca - cb| <= ra - rb.
bool contains_sphere(const Sphere& sphere_a, const Sphere& sphere_b) {
  const RationalPoint a = to_rational(sphere_a.centre);
  const RationalPoint b = to_rational(sphere_b.centre);
  mpq_class square = 0;
  for (int k = 0; k < 3; ++k)
    square += (a[k] - b[k]) * (a[k] - b[k]);
  const mpq_class room = mpq_class(sphere_a.radius) - mpq_class(sphere_b.radius);
  return room >= 0 && square <= room * room;
}

TEST(FitMerged, AlignedBoxesAndKDopsAreExact) {
  RandomSource source(2);
  for (int i = 0; i < 50; ++i) {
    Points a;
    Points b;
    for (int k = 0; k < 10; ++k) {
      a.push_back(source.vector(-1, 1));
      b.push_back(source.vector(0, 2));
    }
    Points both = a;
    both.insert(both.end(), b.begin(), b.end());
    const Aabb box = merged(bounding_aabb(a), bounding_aabb(b));
    EXPECT_EQ(box.min, bounding_aabb(both).min);
    EXPECT_EQ(box.max, bounding_aabb(both).max);
    const KDop<18> kdop = merged(bounding_kdop(a), bounding_kdop(b));
    const KDop<18> expected = bounding_kdop(both);
    EXPECT_EQ(kdop.min, expected.min);
    EXPECT_EQ(kdop.max, expected.max);
  }
}

TEST(FitMerged, SpheresAreContainedAndTouched) {
  RandomSource source(3);
  const double scales[] = {1e-300, 0x1p-1060, 1e-3, 1, 1e9, 1e300};
  for (int i = 0; i < 2000; ++i) {
    const double scale_a = scales[static_cast<int>(source.integer(0, 5))];
    const double scale_b = i % 2 == 0 ? scale_a : scales[static_cast<int>(source.integer(0, 5))];
    Sphere a{source.lattice_point(-3, 3) * scale_a, source.integer(0, 4) * scale_a};
    Sphere b{source.vector(-3, 3) * scale_b, source.uniform(0, 4) * scale_b};
    if (i % 5 == 0) b.centre = a.centre;
    const Sphere sphere = merged(a, b);
    EXPECT_NO_THROW(check_sphere(sphere, "sphere"));
    EXPECT_TRUE(contains_sphere(sphere, a)) << i;
    EXPECT_TRUE(contains_sphere(sphere, b)) << i;
    const double span =
        (0.5 * a.centre - 0.5 * b.centre).stableNorm() + 0.5 * a.radius + 0.5 * b.radius;
    const double expected = std::max({span, a.radius, b.radius});
    const double offset = std::max(a.centre.stableNorm(), b.centre.stableNorm());
    EXPECT_LE(sphere.radius, expected * (1 + 1e-14) + offset * 1e-15 + 1e-320) << i;
  }
}

TEST(FitMerged, ASphereInsideAnotherChangesNothing) {
  const Sphere large{{1, 2, 3}, 2};
  for (const Sphere& small : {Sphere{{1, 2, 3}, 2}, Sphere{{1, 2, 3}, 0}, Sphere{{2, 2, 3}, 0.9},
                              Sphere{{1, 2, 3 + 1e-200}, 1e-200}}) {
    for (const Sphere& sphere : {merged(large, small), merged(small, large)}) {
      EXPECT_EQ(sphere.centre, large.centre);
      EXPECT_EQ(sphere.radius, large.radius);
    }
  }
}

TEST(FitMerged, SpheresThatOverflowOrAreInvalidAreRefused) {
  const double big = std::numeric_limits<double>::max();
  const Sphere left{{-big, 0, 0}, 0};
  const Sphere right{{big, 0, 0}, 0};
  EXPECT_THROW(merged(left, Sphere{{big, big, 0}, 1}), InputError);
  const Sphere sphere = merged(Sphere{{-0.9 * big, 0, 0}, 0}, Sphere{{0.9 * big, 0, 0}, 1e300});
  EXPECT_TRUE(contains_sphere(sphere, Sphere{{-0.9 * big, 0, 0}, 0}));
  EXPECT_TRUE(contains_sphere(sphere, Sphere{{0.9 * big, 0, 0}, 1e300}));
  EXPECT_THROW(merged(right, Sphere{{0, 0, 0}, -1}), InputError);
  EXPECT_THROW(merged(Sphere{{0, std::nan(""), 0}, 1}, right), InputError);
}

constexpr std::array<int, 3> kSigns[] = {{1, 1, 1},  {1, 1, -1},  {1, -1, 1},  {1, -1, -1},
                                         {-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}};

/// A random box, flat or a point at times, with a rotation that may be distorted.
Obb random_box(RandomSource& source) {
  Obb box{random_pose(3, source), source.vector(0, 1)};
  if (source.integer(0, 3) == 0) box.half_extents.y() = 0;
  if (source.integer(0, 5) == 0) box.half_extents.setZero();
  if (source.integer(0, 1) == 0) box.pose = distorted(box.pose, 2e-7, source);
  return box;
}

TEST(FitMerged, OrientedBoxesContainAllCornersInBothReadings) {
  RandomSource source(4);
  const double offsets[] = {0, 1, 1e9};
  for (int i = 0; i < 300; ++i) {
    Obb a = random_box(source);
    Obb b = random_box(source);
    const double offset = offsets[i % 3];
    a.pose.translation() += Eigen::Vector3d{offset, -offset, 2 * offset};
    b.pose.translation() += Eigen::Vector3d{offset, -offset, 2 * offset};
    const Obb box = merged(a, b);
    EXPECT_NO_THROW(check_box(box, "box"));
    for (const Obb* part : {&a, &b}) {
      for (const std::array<int, 3>& signs : kSigns)
        EXPECT_TRUE(contains(box, corner(*part, signs))) << i;
      // Points of doubles on the faces, as law 3 sees them.
      for (int j = 0; j < 20; ++j) {
        Eigen::Vector3d y = source.vector(-1, 1).cwiseProduct(part->half_extents);
        const int k = j % 3;
        y[k] = (j % 2 == 0 ? 1 : -1) * part->half_extents[k];
        const Eigen::Vector3d point = part->pose * y;
        if (contains_by_law_3(*part, point)) {
          EXPECT_TRUE(contains_by_law_3(box, point)) << i;
        }
      }
    }
  }
}

TEST(FitMerged, OrientedBoxesThatAreInvalidOrOverflowAreRefused) {
  const Obb unit{Pose::Identity(), {1, 1, 1}};
  Obb bad = unit;
  bad.half_extents.x() = -1;
  EXPECT_THROW(merged(unit, bad), InputError);
  bad = unit;
  bad.pose.linear() *= 1.1;
  EXPECT_THROW(merged(bad, unit), PoseError);
  bad = unit;
  bad.pose.translation().x() = std::numeric_limits<double>::max();
  bad.half_extents.x() = std::numeric_limits<double>::max();
  EXPECT_THROW(merged(unit, bad), InputError);
}

TEST(FitMerged, TwoHalvesOfABoxMakeTheBox) {
  RandomSource source(5);
  const Pose pose = random_pose(1, source);
  Obb left{pose, {1, 0.5, 0.25}};
  Obb right = left;
  left.pose.translation() = pose * Eigen::Vector3d{-1, 0, 0};
  right.pose.translation() = pose * Eigen::Vector3d{1, 0, 0};
  Eigen::Vector3d half = merged(left, right).half_extents;
  std::sort(half.data(), half.data() + 3);
  EXPECT_TRUE(half.isApprox(Eigen::Vector3d{0.25, 0.5, 2}, 1e-12)) << half.transpose();
}

}  // namespace
}  // namespace graze::tests

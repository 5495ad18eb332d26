// Volumes and surfaces against closed forms.

#include <graze/bvh/fit/kdop_fit.h>
#include <graze/bvh/fit/measure.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/bvh/fit/point_sets.h"
#include "tests/shapes/random_source.h"

namespace graze::tests {
namespace {

constexpr double kPi = std::numbers::pi;

/// The box [0, size] with slabs of sums so loose that they cut nothing off.
KDop<18> loose_kdop(const Eigen::Vector3d& size) {
  KDop<18> kdop;
  kdop.min.fill(-100);
  kdop.max.fill(100);
  for (int k = 0; k < 3; ++k) {
    kdop.min[k] = 0;
    kdop.max[k] = size[k];
  }
  return kdop;
}

TEST(FitMeasure, BoxesAndSpheres) {
  EXPECT_EQ(volume(Aabb{{1, 2, 3}, {2, 4, 6}}), 6);
  EXPECT_EQ(surface(Aabb{{1, 2, 3}, {2, 4, 6}}), 22);
  EXPECT_EQ(volume(Obb{Pose::Identity(), {0.5, 1, 1.5}}), 6);
  EXPECT_EQ(surface(Obb{Pose::Identity(), {0.5, 1, 1.5}}), 22);
  EXPECT_EQ(surface(Aabb{{0, 0, 0}, {1, 1, 0}}), 2) << "both sides";
  EXPECT_DOUBLE_EQ(volume(Sphere{{1, 2, 3}, 2}), 32 * kPi / 3);
  EXPECT_DOUBLE_EQ(surface(Sphere{{1, 2, 3}, 2}), 16 * kPi);
  EXPECT_EQ(volume(Sphere{{1, 2, 3}, 0}), 0);
}

TEST(FitMeasure, AKDopOfABoxIsTheBox) {
  const Eigen::Vector3d size{1, 2, 0.5};
  Points corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(Eigen::Vector3d(i & 1, i >> 1 & 1, i >> 2).cwiseProduct(size));
  for (const KDop<18>& kdop : {bounding_kdop(corners), loose_kdop(size)}) {
    EXPECT_NEAR(volume(kdop), 1, 1e-14);
    EXPECT_NEAR(surface(kdop), 7, 1e-13);
  }
}

TEST(FitMeasure, TruncatedBoxes) {
  // One edge of the unit cube bevelled off: a prism over a triangle with legs c.
  for (double c : {0.0, 0.25, 0.5, 1.0}) {
    KDop<18> kdop = loose_kdop({1, 1, 1});
    kdop.max[3] = 2 - c;
    EXPECT_NEAR(volume(kdop), 1 - c * c / 2, 1e-14);
    EXPECT_NEAR(surface(kdop), 6 - 2 * c + std::sqrt(2) * c - c * c, 1e-13);
  }
  // All twelve edges bevelled so far that the cube's faces are gone: the rhombic dodecahedron with
  // edge sqrt(3) / 2, whose volume is 16 sqrt(3) / 9 and surface 8 sqrt(2) times its edge's power.
  KDop<18> kdop;
  kdop.min.fill(-1);
  kdop.max.fill(1);
  const double edge = std::sqrt(3) / 2;
  EXPECT_NEAR(volume(kdop), 16 * std::sqrt(3) / 9 * edge * edge * edge, 1e-13);
  EXPECT_NEAR(surface(kdop), 8 * std::sqrt(2) * edge * edge, 1e-13);
}

// The k-DOP of the cuboctahedron's corners (+-1, +-1, 0): the cube's faces and the bevels x + y <=
// 2, which touch the corners only. So it is the cube of edge 2 cut by nothing.
TEST(FitMeasure, CuboctahedronAndOctahedron) {
  Points cuboctahedron;
  for (int i = 0; i < 4; ++i) {
    const double a = i & 1 ? 1 : -1;
    const double b = i & 2 ? 1 : -1;
    cuboctahedron.insert(cuboctahedron.end(), {{a, b, 0}, {a, 0, b}, {0, a, b}});
  }
  EXPECT_NEAR(volume(bounding_kdop(cuboctahedron)), 8, 1e-13);
  EXPECT_NEAR(surface(bounding_kdop(cuboctahedron)), 24, 1e-13);
  // The octahedron's: x <= 1 and x + y <= 1, the rhombic dodecahedron above.
  const Points octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  EXPECT_NEAR(volume(bounding_kdop(octahedron)), 2, 1e-13);
}

TEST(FitMeasure, FlatStraightAndEmptyKDops) {
  EXPECT_NEAR(surface(loose_kdop({2, 3, 0})), 12, 1e-13);
  EXPECT_EQ(volume(loose_kdop({2, 3, 0})), 0);
  EXPECT_EQ(surface(loose_kdop({2, 0, 0})), 0);
  EXPECT_EQ(surface(loose_kdop({0, 0, 0})), 0);
  const Points tilted{{0, 0, 0}, {1, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  EXPECT_NEAR(surface(bounding_kdop(tilted)), 2 * std::sqrt(2), 1e-13);
  EXPECT_NEAR(volume(bounding_kdop(tilted)), 0, 1e-15);
  KDop<18> empty = loose_kdop({1, 1, 1});
  empty.min[3] = 3;
  EXPECT_EQ(volume(empty), 0);
  EXPECT_EQ(surface(empty), 0);
}

TEST(FitMeasure, ScalesAndMoves) {
  RandomSource source(10);
  for (int i = 0; i < 50; ++i) {
    Points points;
    for (int k = 0; k < 30; ++k)
      points.push_back(source.lattice_point(-1000, 1000) * 0x1p-10);
    const double expected_volume = volume(bounding_kdop(points));
    const double expected_surface = surface(bounding_kdop(points));
    EXPECT_LT(expected_volume, volume(Aabb{{-1, -1, -1}, {1, 1, 1}}));
    for (double factor : {0x1p-100, 4.0, 0x1p90}) {
      const KDop<18> kdop = bounding_kdop(scaled(points, factor));
      EXPECT_EQ(volume(kdop), expected_volume * factor * factor * factor);
      EXPECT_EQ(surface(kdop), expected_surface * factor * factor);
    }
    const KDop<18> far = bounding_kdop(moved(points, {0x1p30, -0x1p31, 0x1p32}));
    EXPECT_NEAR(volume(far), expected_volume, 1e-13 * expected_volume);
    EXPECT_NEAR(surface(far), expected_surface, 1e-13 * expected_surface);
  }
}

TEST(FitMeasure, ExtremeSizes) {
  KDop<18> kdop;
  kdop.min.fill(-1e308);
  kdop.max.fill(1e308);
  EXPECT_EQ(volume(kdop), HUGE_VAL);
  // A box of 1e100 metres in slabs that are looser by far.
  for (int i : {0, 1, 2}) {
    kdop.min[i] = -0.5e100;
    kdop.max[i] = 0.5e100;
  }
  EXPECT_NEAR(volume(kdop), 1e300, 1e287);
  EXPECT_NEAR(surface(kdop), 6e200, 1e187);
  kdop.min.fill(0);
  kdop.max.fill(5e-324);
  EXPECT_EQ(volume(kdop), 0);
}

// Cutting a polytope in two by one of its directions adds up: a law that no closed form is behind.
TEST(FitMeasure, PartsAddUp) {
  RandomSource source(11);
  for (int i = 0; i < 200; ++i) {
    Points points;
    for (int k = 0; k < 20; ++k)
      points.push_back(source.vector(-1, 1));
    const KDop<18> whole = bounding_kdop(points);
    const int slab = i % 9;
    const double cut = source.uniform(whole.min[slab], whole.max[slab]);
    KDop<18> low = whole;
    KDop<18> high = whole;
    low.max[slab] = cut;
    high.min[slab] = cut;
    EXPECT_NEAR(volume(low) + volume(high), volume(whole), 1e-13);
    EXPECT_GT(surface(low) + surface(high), surface(whole));
  }
}

}  // namespace
}  // namespace graze::tests

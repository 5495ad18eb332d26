#include <graze/bvh/error.h>
#include <graze/narrowphase/volumes/contains.h>
#include <graze/narrowphase/volumes/obb_overlap.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "tests/narrowphase/volumes/obb_cases.h"
#include "tests/narrowphase/volumes/rational_boxes.h"
#include "tests/narrowphase/volumes/simd_targets.h"

namespace graze {
namespace {

using oracle::Reading;
using oracle::Separation;

Obb cube(double half, const Eigen::Vector3d& centre = {0, 0, 0}) {
  Obb box{Pose::Identity(), {half, half, half}};
  box.pose.translation() = centre;
  return box;
}

Obb moved(const Obb& box, const Eigen::Vector3d& way) {
  Obb result = box;
  result.pose.translation() += way;
  return result;
}

/// The distances between which the answer changes; at the larger one the boxes are said to be
/// apart.
Border border(const ObbCase& pair) {
  const double far = 4 * pair.size() + 1e-300 + 1e-6 * pair.a.pose.translation().norm();
  EXPECT_FALSE(intersects(pair.a, pair.b_at(far)));
  EXPECT_TRUE(intersects(pair.a, pair.b_at(0)));
  return find_border(0, far, [&](double s) { return intersects(pair.a, pair.b_at(s)); });
}

/// No reading of the boxes may have a common point.
void expect_apart(const Obb& a, const Obb& b, Lie lie) {
  for (Reading read_a : {Reading::Image, Reading::Transpose}) {
    for (Reading read_b : {Reading::Image, Reading::Transpose})
      ASSERT_TRUE(separation(a, b, read_a, read_b).is_apart) << name_of(lie);
  }
}

/// What intersects() promises of its tightness: metres.
double promised(const ObbCase& pair) {
  const double deviation =
      std::max(rotation_deviation(pair.a.pose), rotation_deviation(pair.b.pose));
  const double beyond_rounding = deviation > 0x1p-51 ? 20 * deviation : 0;
  return (3e-14 + beyond_rounding) * pair.size() + 1e-320;
}

/// Counts how often a border is off by more than 1e-12 of the size.
struct Tally {
  int cases = 0;
  int loose = 0;
};

void check_border(Lie lie, RandomSource& random, Tally& tally) {
  const ObbCase pair = random_case(lie, random);
  const Border found = border(pair);
  expect_apart(pair.a, pair.b_at(found.apart), lie);
  const Obb b = pair.b_at(found.hit);
  const Separation exact = separation(pair.a, b, Reading::Image, Reading::Image);
  ASSERT_LE(exact.sine_gap, promised(pair)) << name_of(lie);
  ++tally.cases;
  tally.loose += exact.gap > 1e-12 * pair.size() + 1e-320;
}

// Borders between "overlap" and "apart", found to the last bit: apart is true, and overlap not far
// from it.
void check_borders(int each, std::uint64_t seed) {
  for (Lie lie : kEveryLie) {
    RandomSource random(seed + static_cast<std::uint64_t>(lie));
    Tally tally;
    for (int n = 0; n < each; ++n) {
      check_border(lie, random, tally);
      if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_EQ(tally.cases, each);
    // Only edges at a small angle leave more room, where no face separates, and loose poses.
    const bool may_be_loose = lie == Lie::NearlyParallel || lie == Lie::NotQuiteRigid;
    EXPECT_LE(tally.loose, may_be_loose ? each : 0) << name_of(lie);
  }
}

TEST(Law11Obb, ApartIsTrueAndOverlapTightAtTheBorder) {
  check_borders(600, 1);
}

TEST(Law11ObbSlow, ApartIsTrueAndOverlapTightAtTheBorder) {
  check_borders(20000, 1000);
}

// The gap that no axis proves is never large, whatever the angle of the edges.
TEST(Law11Obb, NearlyParallelEdgesCostLittle) {
  RandomSource random(2);
  double worst = 0;
  for (int n = 0; n < 3000; ++n) {
    const ObbCase pair = random_case(Lie::NearlyParallel, random);
    const Obb b = pair.b_at(border(pair).hit);
    const double gap = separation(pair.a, b, Reading::Image, Reading::Image).gap;
    worst = std::max(worst, gap / pair.size());
  }
  EXPECT_LT(worst, 1e-7);
}

void check_any_distance(int each, std::uint64_t seed) {
  RandomSource random(seed);
  int apart = 0, touching = 0;
  for (int n = 0; n < each * static_cast<int>(kLies); ++n) {
    const Lie lie = kEveryLie[static_cast<std::size_t>(n) % kLies];
    const ObbCase pair = random_case(lie, random);
    const Obb b = pair.b_at(random.uniform(0, 1) * pair.size());
    const bool is_hit = intersects(pair.a, b);
    ASSERT_EQ(is_hit, intersects(b, pair.a)) << name_of(lie);
    (is_hit ? touching : apart) += 1;
    if (!is_hit) expect_apart(pair.a, b, lie);
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(apart, 4 * each);
  EXPECT_GT(touching, 2 * each);
}

TEST(Law11Obb, ApartIsTrueAtAnyDistance) {
  check_any_distance(500, 3);
}

TEST(Law11ObbSlow, ApartIsTrueAtAnyDistance) {
  check_any_distance(10000, 4);
}

TEST(Law4Obb, SwappingTheBoxesChangesNothingAtTheBorder) {
  RandomSource random(5);
  for (int n = 0; n < 6000; ++n) {
    const ObbCase pair = random_case(kEveryLie[static_cast<std::size_t>(n) % kLies], random);
    const Border found = border(pair);
    for (double s : {found.hit, found.apart})
      ASSERT_EQ(intersects(pair.a, pair.b_at(s)), intersects(pair.b_at(s), pair.a));
  }
}

/// The smallest box about the origin of `pose` that holds the point by law 3's rounding.
Obb box_up_to(const Pose& pose, const Eigen::Vector3d& point) {
  Obb box{pose, {0, 0, 0}};
  for (int i = 0; i < 3; ++i) {
    const double* m = pose.data();
    const double q[3] = {point[0] - m[12], point[1] - m[13], point[2] - m[14]};
    box.half_extents[i] = std::abs((m[4 * i] * q[0] + m[4 * i + 1] * q[1]) + m[4 * i + 2] * q[2]);
  }
  return box;
}

// Two boxes that meet in a corner of each, which is one double point: law 3 says that both hold it.
TEST(Law3Obb, BoxesThatContainOnePointOverlap) {
  RandomSource random(6);
  for (int n = 0; n < 40000; ++n) {
    ObbCase pair = random_case(kEveryLie[static_cast<std::size_t>(n) % kLies], random);
    const double size = n % 5 == 0 ? 1e3 : n % 5 == 1 ? 1e-3 : 1;
    const Eigen::Vector3d point = pair.a.pose.translation() + random.vector(-1, 1) * size;
    pair.b.pose.translation() =
        point + random.vector(0, 1).cwiseProduct((point - pair.a.pose.translation()).cwiseSign());
    const Obb a = box_up_to(pair.a.pose, point);
    const Obb b = box_up_to(pair.b.pose, point);
    ASSERT_TRUE(contains(a, point) && contains(b, point));
    ASSERT_TRUE(intersects(a, b)) << n;
    ASSERT_TRUE(intersects(Aabb{point, point}, b)) << n;
  }
}

TEST(ObbOverlap, CubesFaceToFaceAndEdgeToEdge) {
  EXPECT_TRUE(intersects(cube(1), cube(1, {2, 0, 0})));
  EXPECT_TRUE(intersects(cube(1), cube(1, {2, 2, 2})));
  EXPECT_FALSE(intersects(cube(1), cube(1, {2 + 1e-12, 0, 0})));
  EXPECT_FALSE(intersects(cube(1), cube(1, {0, 0, -3})));
  Obb on_edge = cube(1);
  on_edge.pose.linear() = Eigen::AngleAxisd(M_PI / 4, Eigen::Vector3d::UnitZ()).matrix();
  Obb other = on_edge;
  other.pose.linear() = Eigen::AngleAxisd(M_PI / 4, Eigen::Vector3d::UnitY()).matrix();
  const double reach = 2 * std::sqrt(2.0);
  EXPECT_TRUE(intersects(on_edge, moved(other, {reach - 1e-12, 0, 0})));
  EXPECT_FALSE(intersects(on_edge, moved(other, {reach + 1e-12, 0, 0})))
      << "only the product of two edges separates these";
}

TEST(ObbOverlap, PointsAreBoxes) {
  EXPECT_TRUE(intersects(cube(0, {1, 2, 3}), cube(0, {1, 2, 3})));
  EXPECT_FALSE(intersects(cube(0, {1, 2, 3}), cube(0, {1, 2, std::nextafter(3.0, 4.0)})));
  EXPECT_FALSE(intersects(cube(0, {0, 0, 0}), cube(0, {1e-300, 0, 0})));
  EXPECT_TRUE(intersects(cube(0, {0x1p-1074, 0, 0}), cube(0, {0, 0, 0}))) << "not sure";
}

TEST(ObbOverlap, WhatOverflowsIsNeverSilentlyApart) {
  const double huge = std::numeric_limits<double>::max();
  EXPECT_TRUE(intersects(cube(huge), cube(huge, {huge, 0, -huge})));
  EXPECT_TRUE(intersects(cube(1e308, {-huge, 0, 0}), cube(1e308, {huge, 0, 0}))) << "not sure";
  EXPECT_TRUE(intersects(cube(huge), cube(0, {huge, huge, huge})));
  EXPECT_FALSE(intersects(cube(1, {-huge, 0, 0}), cube(1, {huge, 0, 0})));
  EXPECT_FALSE(intersects(cube(0x1p997), cube(0x1p997, {huge, 0, 0})));
  EXPECT_TRUE(intersects(cube(0x1p997), cube(0x1p997, {0x1p998, 0, 0})));
  EXPECT_TRUE(intersects(Aabb{{-huge, -huge, -huge}, {huge, huge, huge}}, cube(1, {huge, 0, 0})));
  EXPECT_FALSE(intersects(Aabb{{-huge, 0, 0}, {-huge, 0, 0}}, cube(1, {huge, 0, 0})));
}

// Turned boxes that reach each other over nearly the whole range of doubles. On the way into A's
// frame, x + y + z of (1, 1, -1) overflows before z is subtracted. The sum of half extents of each
// box alone is finite.
TEST(ObbOverlap, WhatOverflowsOnTheWayIsNotApart) {
  const double huge = std::numeric_limits<double>::max();
  const Eigen::Vector3d way = Eigen::Vector3d(1, 1, -1).normalized();
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 1, 1).normalized();
  const Eigen::Vector3d across = (way - way.dot(axis) * axis).normalized();
  const Eigen::Vector3d third = axis.cross(across);
  Obb a{Pose::Identity(), {0.195 * huge, 0.388 * huge, 0.388 * huge}};
  a.pose.linear().col(0) = axis;
  a.pose.linear().col(1) = (across + third) / std::sqrt(2.0);
  a.pose.linear().col(2) = (third - across) / std::sqrt(2.0);
  a.pose.translation() = Eigen::Vector3d(-0.435, -0.435, 0.435) * huge;
  Obb b{Pose::Identity(), {0.93 * huge, 0, 0}};
  b.pose.linear().col(0) = way;
  b.pose.linear().col(1) = across.cross(third).cross(way).normalized();
  b.pose.linear().col(2) = way.cross(b.pose.linear().col(1));
  b.pose.translation() = -a.pose.translation();
  ASSERT_FALSE(separation(a, b, Reading::Image, Reading::Image).is_apart);
  EXPECT_TRUE(intersects(a, b));
  EXPECT_TRUE(intersects(b, a));
}

TEST(Law10ObbOverlap, BadBoxesAreRefused) {
  const Obb good = cube(1);
  const Aabb aligned{{0, 0, 0}, {1, 1, 1}};
  Obb negative = good, not_finite = good, loose = good, mirrored = good;
  negative.half_extents.y() = -1;
  not_finite.half_extents.x() = HUGE_VAL;
  loose.pose.linear() *= 1.001;
  mirrored.pose.linear().col(0) *= -1;
  for (const Obb& bad : {negative, not_finite}) {
    EXPECT_THROW(intersects(good, bad), InputError);
    EXPECT_THROW(intersects(bad, good), InputError);
    EXPECT_THROW(intersects(aligned, bad), InputError);
    EXPECT_THROW(intersects(bad, aligned), InputError);
  }
  for (const Obb& bad : {loose, mirrored}) {
    EXPECT_THROW(intersects(good, bad), PoseError);
    EXPECT_THROW(intersects(bad, good), PoseError);
    EXPECT_THROW(intersects(aligned, bad), PoseError);
  }
  EXPECT_THROW(intersects(Aabb{{0, 0, 0}, {1, -1, 1}}, good), InputError);
  EXPECT_THROW(intersects(good, Aabb{{0, 0, 0}, {1, std::nan(""), 1}}), InputError);
  try {
    intersects(good, negative);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "box b: half extent y is negative or not finite");
  }
}

// One number of a box is spoilt, whichever of the two is the larger one, on every SIMD target.
TEST(Law10ObbOverlap, EveryNumberIsLookedAt) {
  const auto expect_refused = [](const Obb& bad, const std::string& what) {
    for (const double half : {0.5, 1.0, 2.0}) {
      EXPECT_THROW(intersects(bad, cube(half)), Error) << what;
      EXPECT_THROW(intersects(cube(half), bad), Error) << what;
    }
  };
  const double infinity = HUGE_VAL;
  for (const std::int64_t target : simd_targets()) {
    force_simd_target(target);
    EXPECT_TRUE(intersects(cube(0.5), cube(1)));
    for (const double value : {std::nan(""), infinity, -infinity}) {
      for (int i = 0; i < 16; ++i) {
        Obb bad = cube(1);
        bad.pose.data()[i] = value;
        expect_refused(bad, std::to_string(i) + " of " + hwy::TargetName(target));
      }
    }
    for (int i = 0; i < 12; ++i) {
      if (i % 4 != 3) continue;
      Obb bad = cube(1);
      bad.pose.data()[i] = 0x1p-1074;
      expect_refused(bad, std::to_string(i) + " of " + hwy::TargetName(target));
    }
    for (const double value : {std::nan(""), infinity, -0x1p-1074}) {
      for (int i = 0; i < 3; ++i) {
        Obb bad = cube(1);
        bad.half_extents[i] = value;
        expect_refused(bad, "half extent " + std::to_string(i) + " of " + hwy::TargetName(target));
      }
    }
    // A shear turns one angle alone out of bounds, a stretch one length.
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        Obb bad = cube(1);
        bad.pose.linear()(i, k) += 1.5 * kMaxRotationDeviation;
        expect_refused(bad, std::to_string(3 * i + k) + " off by " + hwy::TargetName(target));
        bad.pose.linear()(i, k) -= 1.1 * kMaxRotationDeviation;
        EXPECT_NO_THROW(intersects(bad, cube(0.5)));
      }
      Obb mirrored = cube(1);
      mirrored.pose.linear()(i, i) = -1;
      expect_refused(mirrored, "mirrored " + std::to_string(i));
    }
  }
  force_simd_target(0);
}

}  // namespace
}  // namespace graze

// Every volume contains the points it was fitted to, in rational arithmetic.

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

namespace graze::tests {
namespace {

using FitObb = Obb (*)(std::span<const Eigen::Vector3d>);
using FitSphere = Sphere (*)(std::span<const Eigen::Vector3d>);

constexpr FitObb kObbFits[] = {covariance_box, ditetrahedron_box, bounding_obb};
constexpr FitSphere kSphereFits[] = {ritter_sphere, bounding_sphere};

TEST(FitContainment, AlignedBoxesContainAndTouch) {
  for (const PointSet& set : hard_sets()) {
    const Aabb box = bounding_aabb(set.points);
    EXPECT_NO_THROW(check_box(box, "box"));
    Eigen::Vector3d low = set.points[0];
    Eigen::Vector3d high = set.points[0];
    for (const Eigen::Vector3d& point : set.points) {
      EXPECT_TRUE(contains(box, to_rational(point))) << set.name;
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    EXPECT_EQ(box.min, low) << set.name;
    EXPECT_EQ(box.max, high) << set.name;
  }
}

TEST(FitContainment, SpheresContain) {
  for (const PointSet& set : hard_sets()) {
    for (FitSphere fit : kSphereFits) {
      const Sphere sphere = fit(set.points);
      EXPECT_NO_THROW(check_sphere(sphere, "sphere"));
      for (const Eigen::Vector3d& point : set.points)
        ASSERT_TRUE(contains(sphere, to_rational(point))) << set.name;
    }
  }
}

TEST(FitContainment, KDopsContainAndAreTight) {
  for (const PointSet& set : hard_sets()) {
    const KDop<18> kdop = bounding_kdop(set.points);
    EXPECT_NO_THROW(check_kdop(kdop, "k-DOP"));
    for (int i = 0; i < KDop<18>::kSlabs; ++i) {
      const std::array<int, 3>& d = kKDopDirections<18>[i];
      mpq_class low;
      mpq_class high;
      for (std::size_t j = 0; j < set.points.size(); ++j) {
        const RationalPoint p = to_rational(set.points[j]);
        const mpq_class height = p[0] * d[0] + p[1] * d[1] + p[2] * d[2];
        low = j == 0 ? height : std::min(low, height);
        high = j == 0 ? height : std::max(high, height);
      }
      // The bound is the exact one or the next double beyond: one step inward does not contain.
      EXPECT_TRUE(kdop.min[i] <= low) << set.name;
      EXPECT_TRUE(std::nextafter(kdop.min[i], HUGE_VAL) > low) << set.name;
      EXPECT_TRUE(kdop.max[i] >= high) << set.name;
      EXPECT_TRUE(std::nextafter(kdop.max[i], -HUGE_VAL) < high) << set.name;
    }
  }
}

TEST(FitContainment, OrientedBoxesContainInBothReadings) {
  for (const PointSet& set : hard_sets()) {
    for (FitObb fit : kObbFits) {
      const Obb box = fit(set.points);
      EXPECT_NO_THROW(check_box(box, "box")) << set.name;
      EXPECT_LE(rotation_deviation(box.pose), 1e-15) << set.name;
      for (const Eigen::Vector3d& point : set.points) {
        ASSERT_TRUE(contains(box, to_rational(point))) << set.name;
        ASSERT_TRUE(contains_by_law_3(box, point)) << set.name;
      }
    }
  }
}

template <typename Fit>
void expect_refused(Fit fit, const char* name) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(fit(Points{}), InputError) << name;
  const double bad_values[] = {std::nan(""), infinity, -infinity};
  for (double bad : bad_values) {
    Points points = plain_sets().back().points;
    points[3].y() = bad;
    points[5].x() = bad;
    try {
      fit(points);
      ADD_FAILURE() << name << " takes " << bad;
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "point 3: coordinate y is not finite") << name;
    }
  }
}

TEST(FitBadInput, NoPointsAndNotFiniteOnesAreRefused) {
  expect_refused(bounding_aabb, "bounding_aabb");
  expect_refused(bounding_kdop, "bounding_kdop");
  expect_refused(ritter_sphere, "ritter_sphere");
  expect_refused(bounding_sphere, "bounding_sphere");
  expect_refused(covariance_box, "covariance_box");
  expect_refused(ditetrahedron_box, "ditetrahedron_box");
  expect_refused(bounding_obb, "bounding_obb");
}

TEST(FitBadInput, WhatOverflowsIsRefused) {
  const double big = std::numeric_limits<double>::max();
  const Points across{{-big, -big, -big}, {big, big, big}, {big, -big, 0}};
  EXPECT_EQ(bounding_aabb(across).max.x(), big);
  EXPECT_THROW(bounding_kdop(across), InputError);
  for (FitSphere fit : kSphereFits)
    EXPECT_THROW(fit(across), InputError);
  EXPECT_THROW(covariance_box(across), InputError);
  const Points along{{-big, 0, 0}, {big, 0, 0}};
  EXPECT_THROW(bounding_sphere(along), InputError) << "the radius is rounded up";
  EXPECT_EQ(bounding_sphere(Points{{-0.5 * big, 0, 0}, {0.5 * big, 0, 0}}).centre.x(), 0);
}

TEST(FitDegenerate, SinglePointsGiveThemselves) {
  for (double size : {0.0, 0.1, 1e300, 5e-324}) {
    const Eigen::Vector3d point{size, -size, size};
    const Points points(5, point);
    for (FitSphere fit : kSphereFits) {
      EXPECT_EQ(fit(points).centre, point);
      EXPECT_EQ(fit(points).radius, 0);
    }
    for (FitObb fit : kObbFits) {
      EXPECT_EQ(fit(points).pose.translation(), point);
      EXPECT_EQ(fit(points).half_extents, Eigen::Vector3d::Zero());
    }
  }
}

}  // namespace
}  // namespace graze::tests

// How well oriented boxes fit.

#include <graze/bvh/fit/aabb_fit.h>
#include <graze/bvh/fit/obb_fit.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/bvh/fit/point_sets.h"
#include "tests/shapes/random_meshes.h"

namespace graze::tests {
namespace {

using FitObb = Obb (*)(std::span<const Eigen::Vector3d>);

double volume_of(const Obb& box) {
  return 8 * box.half_extents.prod();
}

double half_surface_of(const Eigen::Vector3d& size) {
  return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

Eigen::Vector3d sorted_extents(const Obb& box) {
  Eigen::Vector3d half = box.half_extents;
  std::sort(half.data(), half.data() + 3);
  return half;
}

Points box_corners(const Pose& pose, const Eigen::Vector3d& half) {
  Points points;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d signs{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0};
    points.push_back(pose * signs.cwiseProduct(half).eval());
  }
  return points;
}

TEST(FitOrientedBox, FindsABoxAgain) {
  RandomSource source(8);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d half{0.25, source.uniform(0.5, 1), source.uniform(1.5, 3)};
    const Points points = box_corners(random_pose(2, source), half);
    for (const Obb& box :
         {ditetrahedron_box(points), bounding_obb(points), covariance_box(points)}) {
      EXPECT_TRUE(sorted_extents(box).isApprox(half, 1e-12)) << sorted_extents(box).transpose();
    }
  }
}

TEST(FitOrientedBox, AlignedBoxesStayAsTheyAre) {
  const Points points = box_corners(Pose::Identity(), {1, 2, 0.5});
  for (const Obb& box : {ditetrahedron_box(points), bounding_obb(points)}) {
    EXPECT_TRUE(box.pose.linear().isIdentity(0));
    EXPECT_TRUE(box.half_extents.isApprox(Eigen::Vector3d{1, 2, 0.5}, 1e-15));
  }
  // Flat along an axis is flat exactly.
  EXPECT_EQ(ditetrahedron_box(Points{{0, 0, 3}, {1, 0, 3}, {0, 1, 3}, {1, 1, 3}}).half_extents.z(),
            0);
}

TEST(FitOrientedBox, TightIsNeverLargerThanTheOthers) {
  for (const PointSet& set : plain_sets()) {
    const Aabb aligned = bounding_aabb(set.points);
    const double tight = volume_of(bounding_obb(set.points));
    const double allowance = 1e-8 * std::pow((aligned.max - aligned.min).norm(), 3);
    EXPECT_LE(tight, volume_of(covariance_box(set.points)) + allowance) << set.name;
    EXPECT_LE(tight, volume_of(ditetrahedron_box(set.points)) + allowance) << set.name;
    EXPECT_LE(tight, (aligned.max - aligned.min).prod() + allowance) << set.name;
    EXPECT_LE(half_surface_of(2 * ditetrahedron_box(set.points).half_extents),
              half_surface_of(aligned.max - aligned.min) +
                  1e-14 * (aligned.max - aligned.min).squaredNorm() + 1e-30)
        << set.name;
  }
}

TEST(FitOrientedBox, ATurnedRectangleOfAnyPrismIsFound) {
  // A prism over an irregular pentagon: with one axis along it, the best box is over the smallest
  // rectangle, found here by trying all directions.
  const double x[] = {0, 2, 2.5, 1, -0.5};
  const double y[] = {0, 0.3, 1, 1.6, 0.9};
  Points points;
  double least = HUGE_VAL;
  for (int i = 0; i < 5; ++i) {
    points.push_back({x[i], y[i], -3});
    points.push_back({x[i], y[i], 3});
  }
  for (int step = 0; step < 100000; ++step) {
    const double angle = step * 1.5707963267948966 / 100000;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    double low[2] = {HUGE_VAL, HUGE_VAL};
    double high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (int i = 0; i < 5; ++i) {
      const double u[2] = {c * x[i] + s * y[i], c * y[i] - s * x[i]};
      for (int k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], u[k]);
        high[k] = std::max(high[k], u[k]);
      }
    }
    least = std::min(least, (high[0] - low[0]) * (high[1] - low[1]));
  }
  EXPECT_LE(volume_of(bounding_obb(points)), 6 * least * (1 + 1e-12));
  EXPECT_GE(volume_of(bounding_obb(points)), 6 * least * (1 - 1e-3));
}

TEST(FitOrientedBox, FlatAndStraightSetsGiveThinBoxes) {
  RandomSource source(9);
  for (int i = 0; i < 50; ++i) {
    const Pose pose = random_pose(1, source);
    Points flat;
    Points straight;
    for (int k = 0; k < 30; ++k) {
      const Eigen::Vector3d point = source.vector(-1, 1);
      flat.push_back(pose * Eigen::Vector3d{point.x(), 0.4 * point.y(), 0});
      straight.push_back(pose * Eigen::Vector3d{point.x(), 0, 0});
    }
    for (FitObb fit : {covariance_box, ditetrahedron_box, bounding_obb}) {
      EXPECT_LE(sorted_extents(fit(flat)).x(), 1e-14) << i;
      EXPECT_LE(sorted_extents(fit(straight)).y(), 1e-14) << i;
    }
  }
}

TEST(FitOrientedBox, SameInputSameBox) {
  for (const PointSet& set : plain_sets()) {
    const Obb first = bounding_obb(set.points);
    const Obb second = bounding_obb(set.points);
    EXPECT_EQ(first.pose.matrix(), second.pose.matrix());
    EXPECT_EQ(first.half_extents, second.half_extents);
  }
}

}  // namespace
}  // namespace graze::tests

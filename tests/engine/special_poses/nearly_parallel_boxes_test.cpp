// Boxes with an edge of each nearly parallel to the other's, apart along the product of the two.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::Vector3d;

struct TwoBoxes {
  Box a, b;
  Pose pose_a, pose_b;
  double gap;  ///< metres, along the product of the edges; known but for rounding
};

/// Upright, A with an edge along x at its top; B above it with one at its bottom, turned about z by
/// `angle`: the two cross each other above the origin, and the gap is along z. Both boxes are
/// turned about their edges, so that these alone meet.
TwoBoxes crossed(double angle, double gap, RandomSource& source) {
  const Vector3d half_a = source.vector(0.2, 1), half_b = source.vector(0.2, 1);
  TwoBoxes boxes{{half_a}, {half_b}, Pose::Identity(), Pose::Identity(), gap};
  const auto turned_about_edge = [&](double tilt) {
    return Eigen::AngleAxisd(tilt, Vector3d::UnitX()).toRotationMatrix();
  };
  const double tilt_a = source.uniform(0.3, 1.2), tilt_b = source.uniform(0.3, 1.2);
  boxes.pose_a.linear() = turned_about_edge(tilt_a);
  boxes.pose_b.linear() =
      Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix() * turned_about_edge(tilt_b);
  // The corner that is highest, and lowest, is one of an edge along the boxes' own x.
  const double along_a = source.uniform(-0.8, 0.8), along_b = source.uniform(-0.8, 0.8);
  const Vector3d top =
      boxes.pose_a.linear() * Vector3d(along_a * half_a.x(), half_a.y(), half_a.z());
  const Vector3d bottom =
      boxes.pose_b.linear() * Vector3d(along_b * half_b.x(), -half_b.y(), -half_b.z());
  boxes.pose_a.translation() = -top;
  boxes.pose_b.translation() = Vector3d(0, 0, gap) - bottom;
  return boxes;
}

/// Far apart compared with the tolerance, and far compared with rounding.
TEST(NearlyParallelBoxes, AreApartWhereTheyAre) {
  RandomSource source(1301);
  for (int n = 0; n < 20000; ++n) {
    const double angle = std::pow(10.0, source.uniform(-11, -2));
    const double gap = std::pow(10.0, source.uniform(-8, -3));
    TwoBoxes boxes = crossed(angle, gap, source);
    const Pose both =
        Pose(Eigen::Translation3d(source.vector(-3, 3)) *
             Eigen::AngleAxisd{source.uniform(-3, 3), source.vector(-1, 1).normalized()});
    boxes.pose_a = both * boxes.pose_a;
    boxes.pose_b = both * boxes.pose_b;
    const PlacedShape a{boxes.a, boxes.pose_a}, b{boxes.b, boxes.pose_b};
    ASSERT_FALSE(intersects(a, b)) << angle << " " << gap;
    EXPECT_FALSE(intersects(b, a));
    EXPECT_TRUE(find_contacts(a, b).empty());
    EXPECT_NEAR(distance(a, b).distance, gap, 1e-9);
    // And meet where they do.
    const Vector3d up = both.linear() * Vector3d(0, 0, 1);
    boxes.pose_b.translation() -= 2 * gap * up;
    const PlacedShape lower{boxes.b, boxes.pose_b};
    EXPECT_TRUE(intersects(a, lower));
    EXPECT_FALSE(find_contacts(a, lower).empty());
  }
}

/// Boxes that lie flat on each other, turned by nothing or by hardly anything, take no search.
TEST(NearlyParallelBoxes, ThatLieInEachOtherAreNotSearched) {
  const Shape box = Box{{0.5, 0.5, 0.5}};
  for (const double angle : {0.0, 1e-9, 1e-7}) {
    Pose above = Pose::Identity();
    above.linear() = Eigen::AngleAxisd(angle, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    above.translation() = Vector3d(0.1, 0.2, 1 - 1e-5);
    Work work;
    EXPECT_TRUE(intersects({box}, {box, above}, &work));
    EXPECT_EQ(work.convex_tests, 0u) << angle;
  }
}

}  // namespace
}  // namespace graze

#include <graze/bvh/error.h>
#include <graze/engine/mesh/placement.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

constexpr double kMax = std::numeric_limits<double>::max();

// Law 1, spelt out with every rounding forced into memory.
double placed_coordinate(const Pose& pose, const Eigen::Vector3d& p, int i) {
  const volatile double x = pose.linear()(i, 0) * p.x();
  const volatile double y = pose.linear()(i, 1) * p.y();
  const volatile double z = pose.linear()(i, 2) * p.z();
  const volatile double xy = x + y;
  const volatile double xyz = xy + z;
  return xyz + pose.translation()[i];
}

TEST(Law1, EveryOperationIsRoundedInTheStatedOrder) {
  RandomSource source(1);
  for (int n = 0; n < 20000; ++n) {
    const Pose pose = tests::random_pose(10, source);
    const Eigen::Vector3d point = source.vector(-1, 1);
    const Eigen::Vector3d placed = place(pose, point);
    for (int i = 0; i < 3; ++i)
      ASSERT_EQ(placed[i], placed_coordinate(pose, point, i));
  }
}

TEST(Law1, IdentityLeavesEveryValue) {
  RandomSource source(2);
  for (int n = 0; n < 1000; ++n) {
    const Eigen::Vector3d point = source.vector(-1, 1);
    ASSERT_EQ(place(Pose::Identity(), point), point);
  }
  const Eigen::Vector3d extreme(kMax, -kMax, std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(place(Pose::Identity(), extreme), extreme);
}

TEST(Law1, PosesUnderWhichTheBoundsCouldOverflowAreRefused) {
  const Aabb huge{{-kMax, 0, 0}, {kMax, 1, 1}};
  Pose pose = Pose::Identity();
  EXPECT_EQ(check_placement(pose, huge, "pose"), 0);
  pose.translation().x() = kMax;
  EXPECT_THROW(check_placement(pose, huge, "pose"), PoseError);
  pose.translation() = Eigen::Vector3d(0, kMax, 0);
  EXPECT_EQ(check_placement(pose, huge, "pose"), 0) << "this sum rounds to the largest double";
  Pose turned = Pose::Identity();
  turned.linear() = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Aabb huger{{-kMax, -kMax, 0}, {kMax, kMax, 1}};
  try {
    check_placement(turned, huger, "pose of mesh A");
    FAIL();
  } catch (const PoseError& error) {
    EXPECT_STREQ(error.what(), "pose of mesh A: coordinate x of the mesh could overflow");
  }
}

}  // namespace
}  // namespace graze

#include <graze/bvh/error.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/placing/relative_frame.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>
#include <string>

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

TEST(Law1, OverflowIsLookedForAlongEachAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    Aabb huge{{0, 0, 0}, {1, 1, 1}};
    huge.max[axis] = kMax;
    Pose pose = Pose::Identity();
    EXPECT_EQ(check_placement(pose, huge, "pose"), 0);
    pose.translation()[axis] = kMax;
    try {
      check_placement(pose, huge, "pose");
      FAIL() << axis;
    } catch (const PoseError& error) {
      EXPECT_EQ(error.what(),
                std::string("pose: coordinate ") + "xyz"[axis] + " of the mesh could overflow");
    }
  }
}

/// A mesh of half size 1 and unit 1, as relative_frame() sees it.
struct Side {
  double deviation = 0;
  double translation = 0;  // along x, metres
  double centre = 0;       // of the mesh, along y, metres
};

double slack_between(const Side& side_a, const Side& side_b) {
  struct Placed {
    explicit Placed(const Side& side)
        : bounds{{-1, side.centre - 1, -1}, {1, side.centre + 1, 1}},
          frame(bvh::LocalFrame::around(bounds)) {
      pose.translation().x() = side.translation;
    }
    Pose pose = Pose::Identity();
    Aabb bounds;
    bvh::LocalFrame frame;
  };
  const Placed a(side_a), b(side_b);
  return relative_frame({a.pose, side_a.deviation, a.frame, a.bounds},
                        {b.pose, side_b.deviation, b.frame, b.bounds})
      .slack;
}

/// At least what the derivation in relative_frame.cpp asks for, and hardly more.
void expect_slack(double slack, double derived) {
  EXPECT_GE(slack, derived);
  EXPECT_LE(slack, 1.02 * derived);
}

// Where each part of the slack is nearly all of it. u, tau and the rest are those of
// relative_frame.cpp; r is 2.
TEST(Law5Slack, PaysForEachOfItsParts) {
  constexpr double u = 0x1p-53;
  const double alone_a = 3.0 * 8 * u * 2 + 3.5 * 8 * u;
  const double alone_b = (3.0 * 8 + 28) * u * 2 + 3.5 * 8 * u;
  const double axes = 18 * 2 * (3.01 * 8 + 8 + 12) * u;
  expect_slack(slack_between({}, {}), 2 * (alone_a + alone_b) + axes + 128.0 * 16 * u);
  constexpr double kDeviation = 1e-6;
  expect_slack(slack_between({.deviation = kDeviation}, {}),
               (2.0 * 3 * 2 + 18 * 3.01 * 2) * kDeviation);
  expect_slack(slack_between({}, {.deviation = kDeviation}), (2.0 * 3 * 2 + 18.0 * 2) * kDeviation);
  constexpr double kFar = 1e12;
  const double placing = 2 * 3.5 * 8 * u * kFar;
  expect_slack(slack_between({.translation = kFar}, {.translation = kFar}), 2 * placing);
  expect_slack(slack_between({.centre = kFar}, {.centre = kFar}), 2 * placing);
  const double between = (2.0 * 10 + 128) * u * kFar;
  expect_slack(slack_between({.translation = kFar}, {}), placing + between);
  expect_slack(slack_between({}, {.translation = kFar}), placing + between);
}

/// In every number.
void expect_equal(const bvh::RelativeFrame& one, const bvh::RelativeFrame& other) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      EXPECT_EQ(one.rotation[i][j], other.rotation[i][j]);
    EXPECT_EQ(one.translation[i], other.translation[i]);
  }
  EXPECT_EQ(one.units_a, other.units_a);
  EXPECT_EQ(one.units_b, other.units_b);
  EXPECT_EQ(one.slack, other.slack);
}

TEST(RelativeFrame, ReversedIsTheOtherWayRound) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int n = 0; n < 1000; ++n) {
    const auto size = [&] { return std::exp2(100 * uniform(random)); };
    const auto pose = [&] {
      const double w = uniform(random), x = uniform(random), y = uniform(random);
      Pose result = Pose::Identity();
      result.linear() = Eigen::Quaterniond(w, x, y, 1).normalized().toRotationMatrix();
      result.translation() = Eigen::Vector3d{size(), -size(), size()};
      return result;
    };
    const auto box = [&] {
      const Eigen::Vector3d low{-size(), size(), -size()};
      return Aabb{low, low + Eigen::Vector3d{size(), size(), size()}};
    };
    const Pose pose_a = pose(), pose_b = pose();
    const Aabb box_a = box(), box_b = box();
    const bvh::LocalFrame frame_a = bvh::LocalFrame::around(box_a);
    const bvh::LocalFrame frame_b = bvh::LocalFrame::around(box_b);
    const PlacedFrame a{pose_a, 1e-16, frame_a, box_a};
    const PlacedFrame b{pose_b, 1e-7, frame_b, box_b};
    expect_equal(reversed(relative_frame(a, b), a, b), relative_frame(b, a));
  }
}

}  // namespace
}  // namespace graze

// Law 14, where bodies are: poses of motions, and what makes motions.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/rigid/sine_cosine.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = std::numbers::pi;

double difference(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

TEST(Law14Pose, SinesAndCosinesAreWithinTheirBound) {
  RandomSource source(1401);
  for (int i = 0; i < 200000; ++i) {
    const double reach = std::ldexp(1.0, static_cast<int>(source.integer(-30, 20)));
    const double angle = source.uniform(-reach, reach);
    const TurnValues turn = turn_values(angle);
    const long double exact = angle;
    ASSERT_LE(std::abs(static_cast<double>(std::sin(exact) - turn.unit.sine)), kTurnBound) << angle;
    ASSERT_LE(std::abs(static_cast<double>(std::cos(exact) - turn.unit.cosine)), kTurnBound)
        << angle;
    const long double half = std::sin(exact / 2);
    const double versine = static_cast<double>(2 * half * half);
    ASSERT_LE(std::abs(versine - turn.versine),
              std::abs(angle) < 0.78 ? 0x1p-50 * versine : kTurnBound)
        << angle;
  }
  EXPECT_EQ(turn_values(0).unit.sine, 0);
  EXPECT_EQ(turn_values(0).unit.cosine, 1);
  EXPECT_EQ(turn_values(0).versine, 0);
}

TEST(Law14Pose, AnAngleIsFoundFromItsSineAndCosine) {
  for (int i = 0; i <= 1000; ++i) {
    const double angle = kPi / 2 * i / 1000;
    EXPECT_NEAR(angle_of(turn_values(angle).unit), angle, 0x1p-49);
  }
}

TEST(Law14Pose, TheStartIsKeptToTheBitAndPosesStayRigid) {
  RandomSource source(1402);
  for (int i = 0; i < 2000; ++i) {
    const Pose start = tests::distorted(tests::random_pose(3, source), 3e-7, source);
    const RigidMotion motion(start, {.centre = source.vector(-2, 2),
                                     .shift = source.vector(-2, 2),
                                     .axis = source.vector(-1, 1),
                                     .angle = source.uniform(-1e4, 1e4)});
    EXPECT_TRUE(are_equal(motion.at(0), start));
    for (const double t : {0.25, 0.7, 1.0}) {
      const Pose pose = motion.at(t);
      EXPECT_NO_THROW(check_rigid(pose, "at t"));
      const Eigen::AngleAxisd turn(t * motion.angle(), motion.axis());
      Pose expected = start;
      expected.linear() = turn * start.linear();
      expected.translation() =
          motion.centre() + t * motion.shift() + turn * (start.translation() - motion.centre());
      EXPECT_LT(difference(pose, expected), 1e-11);
    }
  }
}

TEST(Law14Pose, MotionsBetweenPosesEndThere) {
  RandomSource source(1403);
  for (int i = 0; i < 4000; ++i) {
    const Pose start = tests::random_pose(3, source);
    Pose end = tests::random_pose(3, source);
    if (i % 4 == 1) end.linear() = start.linear();
    if (i % 4 == 2) {  // nearly half a turn, or little
      const double angle = i % 8 < 4 ? kPi - source.uniform(0, 1e-9) : source.uniform(0, 1e-5);
      end.linear() = Eigen::AngleAxisd(angle, source.vector(-1, 1).normalized()) *
                     Eigen::Matrix3d(start.linear());
    }
    const Vector3d centre = source.vector(-1, 1);
    const RigidMotion straight = RigidMotion::between(start, end, centre);
    EXPECT_LT(difference(straight.at(1), end), 20 * 0x1p-44);
    EXPECT_LE(straight.angle(), kPi * (1 + 1e-15));
    EXPECT_LT((straight.at(0.5) * centre - (start * centre + end * centre) / 2).norm(), 1e-13);
    const RigidMotion screw = RigidMotion::screw_between(start, end);
    const double lengths = 10 + screw.centre().norm() + screw.shift().norm();
    EXPECT_LT(difference(screw.at(1), end), lengths * 0x1p-44);
    if (screw.angle() > 1e-4) {
      EXPECT_LT(screw.axis().cross(screw.shift()).norm(), 1e-12);
    }
    if (i % 4 == 1) {
      EXPECT_EQ(straight.angle(), 0);
    }
  }
}

TEST(Law14Pose, ScrewsAndVelocitiesAreWhatTheySay) {
  RandomSource source(1404);
  const Pose start = tests::random_pose(1, source);
  const RigidMotion screw = RigidMotion::screw(
      start, {.point = {1, 2, 3}, .axis = {0, 0, 5}, .angle = 7 * kPi, .pitch = 2});
  EXPECT_NEAR((screw.shift() - Vector3d(0, 0, 7)).norm(), 0, 1e-14);
  EXPECT_EQ(screw.axis(), Vector3d::UnitZ());
  const Vector3d line(1, 2, -4);
  const Vector3d on_line = start.inverse() * line;
  EXPECT_LT((screw.at(1) * on_line - (line + Vector3d(0, 0, 7))).norm(), 1e-13);

  const RigidMotion moved = RigidMotion::from_velocities(
      start, {.linear = {1, 0, 0}, .angular = {0, 3, 4}, .body_centre = {1, 1, 1}, .duration = 2});
  EXPECT_NEAR(moved.angle(), 10, 1e-14);
  EXPECT_LT(
      (moved.at(1) * Vector3d(1, 1, 1) - start * Vector3d(1, 1, 1) - Vector3d(2, 0, 0)).norm(),
      1e-13);
  EXPECT_EQ(RigidMotion::from_velocities(start, {}).angle(), 0);
  EXPECT_EQ(RigidMotion(start), RigidMotion(start, {.axis = {0, 0, 1e-300}}));
  EXPECT_FALSE(RigidMotion(start) == RigidMotion(start, {.angle = 1}));
}

TEST(Law14Door, WhatIsNoMotionIsRefused) {
  const Pose start = Pose::Identity();
  EXPECT_THROW(RigidMotion(start, {.axis = {0, 0, 0}}), InputError);
  EXPECT_THROW(RigidMotion(start, {.axis = {0, kInfinity, 0}}), InputError);
  EXPECT_THROW(RigidMotion(start, {.angle = kInfinity}), InputError);
  EXPECT_THROW(RigidMotion(start, {.angle = std::nan("")}), InputError);
  EXPECT_THROW(RigidMotion(start, {.angle = 2 * kMostTurned}), InputError);
  EXPECT_THROW(RigidMotion(start, {.centre = {std::nan(""), 0, 0}}), InputError);
  EXPECT_THROW(RigidMotion(start, {.shift = {0, kInfinity, 0}}), InputError);
  EXPECT_THROW(RigidMotion(start, {.shift = {0, 1e305, 0}}), PoseError);
  EXPECT_THROW(RigidMotion(start, {.centre = {0, 1e305, 0}}), PoseError);
  EXPECT_THROW(RigidMotion(start).at(-0.1), InputError);
  EXPECT_THROW(RigidMotion(start).at(1.1), InputError);
  EXPECT_THROW(RigidMotion(start).at(std::nan("")), InputError);
  Pose skew = start;
  skew.matrix()(0, 1) = 1e-3;
  EXPECT_THROW(RigidMotion{skew}, PoseError);
  EXPECT_THROW(RigidMotion::between(start, skew), PoseError);
  EXPECT_THROW(RigidMotion::screw_between(skew, start), PoseError);
  EXPECT_THROW(RigidMotion::from_velocities(start, {.duration = -1}), InputError);
  EXPECT_THROW(RigidMotion::from_velocities(start, {.linear = {kInfinity, 0, 0}}), InputError);
  EXPECT_THROW(RigidMotion::from_velocities(start, {.angular = {1e200, 0, 0}, .duration = 1e200}),
               InputError);
  EXPECT_THROW(RigidMotion::screw(start, {.axis = {0, 0, 0}}), InputError);
}

}  // namespace
}  // namespace graze

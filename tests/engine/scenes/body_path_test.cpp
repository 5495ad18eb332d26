// Paths of bodies: poses in time that hold their keys, turn evenly and are the same everywhere.

#include <graze/engine/scenes/body_path.h>
#include <graze/engine/scenes/path/turn.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

// What a quaternion of some twenty roundings leaves in a matrix; 6 ulp were seen.
constexpr double kSomeUlps = 0x1p-49;

/// Rodrigues' formula, with the C library's sine.
Eigen::Matrix3d by_formula(const Eigen::Vector3d& axis, double turns) {
  const double angle = 2 * M_PI * turns;
  Eigen::Matrix3d cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return Eigen::Matrix3d::Identity() + std::sin(angle) * cross +
         (1 - std::cos(angle)) * (cross * cross);
}

double difference(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

KeyPath random_keys(int count, RandomSource& source) {
  KeyPath path;
  double time = source.uniform(-1, 1);
  for (int i = 0; i < count; ++i) {
    path.keys.push_back({time, tests::random_pose(2, source)});
    time += source.uniform(0.1, 1);
  }
  return path;
}

TEST(BodyPath, TurnsAreWhatTheFormulaSays) {
  RandomSource source(1);
  for (int n = 0; n < 2000; ++n) {
    const Eigen::Vector3d axis = source.vector(-1, 1).normalized();
    const double turns = source.uniform(-1, 1);
    EXPECT_LE(
        difference(scenes::matrix_of(scenes::turned_by(axis, turns)), by_formula(axis, turns)),
        kSomeUlps)
        << turns;
  }
}

TEST(BodyPath, WholeTurnsChangeNothing) {
  RandomSource source(2);
  for (const double turns : {1.0, -1.0, 17.0, -1e15}) {
    const Pose start = tests::random_pose(1, source);
    const SteadyPath path{.velocity = {0, 0, 0}, .axis = {0, 0.6, 0.8}, .rate = turns};
    EXPECT_EQ(pose_at(path, start, 1).matrix(), start.matrix()) << turns;
  }
  // A way so small that its fraction of a turn is rounded to the next whole one.
  const scenes::Quaternion q = scenes::turned_by({0, 0, 1}, -0x1p-80);
  EXPECT_EQ(scenes::matrix_of(q), Eigen::Matrix3d::Identity());
}

TEST(BodyPath, SteadyPathsBeginAtTheStart) {
  RandomSource source(3);
  const Pose start = tests::random_pose(1, source);
  const SteadyPath path{.velocity = {3, -1, 2}, .axis = {1, 0, 0}, .rate = 0.25};
  EXPECT_EQ(pose_at(path, start, 0).matrix(), start.matrix());
  const Pose later = pose_at(path, start, 2);
  EXPECT_EQ(later.translation(), (start.translation() + Eigen::Vector3d(6, -2, 4)));
  EXPECT_LE(difference(later.linear(), by_formula({1, 0, 0}, 0.5) * start.linear()), kSomeUlps);
}

TEST(BodyPath, KeysAreKeptBitForBit) {
  RandomSource source(4);
  for (int n = 0; n < 100; ++n) {
    const KeyPath path = random_keys(5, source);
    for (const PoseKey& key : path.keys)
      EXPECT_EQ(pose_at(path, Pose::Identity(), key.time).matrix(), key.pose.matrix());
    EXPECT_EQ(pose_at(path, Pose::Identity(), -100).matrix(), path.keys.front().pose.matrix());
    EXPECT_EQ(pose_at(path, Pose::Identity(), 100).matrix(), path.keys.back().pose.matrix());
  }
}

TEST(BodyPath, BetweenKeysBodiesTurnEvenlyAlongTheShorterArc) {
  RandomSource source(5);
  for (int n = 0; n < 300; ++n) {
    const Eigen::Vector3d axis = source.vector(-1, 1).normalized();
    const double turns = source.uniform(-0.5, 0.5);
    PoseKey from{0, tests::random_pose(1, source)};
    PoseKey to{4, tests::random_pose(1, source)};
    to.pose.linear() = by_formula(axis, turns) * from.pose.linear();
    const KeyPath path{{from, to}};
    const double fraction = source.uniform(0, 1);
    const Pose pose = pose_at(path, Pose::Identity(), 4 * fraction);
    const Eigen::Matrix3d wanted = by_formula(axis, turns * fraction) * from.pose.linear();
    // Near half a turn the axis itself is known only to ulps over what is missing to it.
    EXPECT_LE(difference(pose.linear(), wanted), kSomeUlps / (0.5 - std::abs(turns))) << turns;
    EXPECT_LE((pose.translation() -
               ((1 - fraction) * from.pose.translation() + fraction * to.pose.translation()))
                  .cwiseAbs()
                  .maxCoeff(),
              kSomeUlps);
    EXPECT_LE(rotation_deviation(pose), kSomeUlps);
  }
}

TEST(BodyPath, QuaternionsAndMatricesAreInverse) {
  RandomSource source(6);
  for (int n = 0; n < 1000; ++n) {
    const Eigen::Matrix3d rotation = tests::random_pose(1, source).linear();
    EXPECT_LE(difference(scenes::matrix_of(scenes::quaternion_of(rotation)), rotation), kSomeUlps);
  }
  for (const Eigen::Vector3d& axis :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)}) {
    for (const double turns : {0.25, 0.5, 0.75}) {
      const Eigen::Matrix3d rotation = scenes::matrix_of(scenes::turned_by(axis, turns));
      EXPECT_LE(difference(scenes::matrix_of(scenes::quaternion_of(rotation)), rotation),
                kSomeUlps);
    }
  }
}

/// A path that overflows is not rigid, so that whoever moves a body along it is told.
TEST(BodyPath, WhatOverflowsIsNoPose) {
  const SteadyPath spin{.velocity = {0, 0, 0}, .axis = {0, 0, 1}, .rate = 1e300};
  EXPECT_THROW(check_rigid(pose_at(spin, Pose::Identity(), 1e300), "pose"), PoseError);
  const SteadyPath flight{.velocity = {1e300, 0, 0}, .axis = {0, 0, 1}, .rate = 0};
  EXPECT_THROW(check_rigid(pose_at(flight, Pose::Identity(), 1e300), "pose"), PoseError);
}

// FNV-1a over the bits of two thousand poses: other compilers and flags must find the same ones.
TEST(Law8Determinism, PosesInTimeAreTheSameEverywhere) {
  std::uint64_t hash = 14695981039346656037u;
  const auto add = [&](const Pose& pose) {
    for (int i = 0; i < 12; ++i) {
      hash ^= std::bit_cast<std::uint64_t>(pose(i / 4, i % 4));
      hash *= 1099511628211u;
    }
  };
  const KeyPath keys{
      {{0, Pose::Identity()},
       {1, pose_at(SteadyPath{{1, 2, 3}, {0, 0.6, 0.8}, 0.4}, Pose::Identity(), 1)},
       {3, pose_at(SteadyPath{{3, 2, 1}, {0.6, 0, 0.8}, 0.3}, Pose::Identity(), 3)}}};
  const SteadyPath steady{{0.1, 0.2, 0.3}, {0.6, 0.8, 0}, 7.3};
  for (int n = 0; n < 1000; ++n) {
    add(pose_at(keys, Pose::Identity(), n * 0.003));
    add(pose_at(steady, keys.keys[1].pose, n * 0.003));
  }
  EXPECT_EQ(hash, 3139791591569021628u);
}

}  // namespace
}  // namespace graze

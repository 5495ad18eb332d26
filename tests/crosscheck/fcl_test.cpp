// graze and FCL on the same meshes and poses. Each difference is settled by the referee: graze may
// be wrong in none.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/crosscheck/cross_check.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using tests::make_box;
using tests::make_sphere;
using tests::make_torus;

/// Poses of B at distances around `touching`, some of them within rounding of it.
std::vector<Pose> grazing_poses(double touching, int count) {
  RandomSource source(7);
  std::vector<Pose> poses;
  for (int i = 0; i < count; ++i) {
    Pose pose = tests::random_pose(0, source);
    const Eigen::Vector3d direction = source.vector(-1, 1).normalized();
    const double spread = std::pow(10.0, -(i % 16));
    pose.translation() = direction * (touching * (1 + spread * source.uniform(-1, 1)));
    poses.push_back(pose);
  }
  return poses;
}

std::vector<Pose> shifts(const std::vector<Eigen::Vector3d>& translations) {
  std::vector<Pose> poses;
  for (const Eigen::Vector3d& t : translations) {
    Pose pose = Pose::Identity();
    pose.translation() = t;
    poses.push_back(pose);
  }
  return poses;
}

TEST(FclCrossCheck, Spheres) {
  const Mesh sphere = make_sphere(1, 12, 20);
  const tests::CrossCheckCounts counts =
      tests::cross_check(sphere, sphere, grazing_poses(1.97, 300));
  EXPECT_GT(counts.intersecting, 10u);
  EXPECT_GT(counts.apart, 10u);
}

TEST(FclCrossCheck, TorusAndBox) {
  const tests::CrossCheckCounts counts = tests::cross_check(
      make_torus(1, 0.25, 24, 10), make_box({0.5, 0.3, 0.2}), grazing_poses(1.4, 300));
  EXPECT_GT(counts.intersecting, 10u);
  EXPECT_GT(counts.apart, 10u);
}

TEST(FclCrossCheck, LinkedTori) {
  const Mesh torus = make_torus(1, 0.25, 24, 10);
  EXPECT_GT(tests::cross_check(torus, torus, grazing_poses(1, 100)).intersecting, 10u);
}

TEST(FclCrossCheck, BoxesFaceOnFaceEdgeOnEdgeAndCornerOnCorner) {
  const Mesh box = make_box({1, 1, 1});
  const double inside = 2 - 0x1p-52;
  const double outside = 2 + 0x1p-51;
  const tests::CrossCheckCounts counts = tests::cross_check(box, box,
                                                            shifts({{2, 0, 0},
                                                                    {2, 2, 0},
                                                                    {2, 2, 2},
                                                                    {0, 0, 0},
                                                                    {1, 0, 0},
                                                                    {inside, 0, 0},
                                                                    {outside, 0, 0},
                                                                    {outside, 2, 0},
                                                                    {inside, inside, 2},
                                                                    {0, 0.5, 2},
                                                                    {2, 2, outside},
                                                                    {0, outside, 0}}));
  EXPECT_EQ(counts.intersecting, 8u);
  EXPECT_EQ(counts.apart, 4u);
  EXPECT_GT(counts.differences, 0u) << "a check that never differs has not looked at hard cases";
}

TEST(FclCrossCheck, AMeshOnItself) {
  const Mesh torus = make_torus(1, 0.25, 24, 10);
  const tests::CrossCheckCounts counts = tests::cross_check(torus, torus, shifts({{0, 0, 0}}));
  EXPECT_EQ(counts.intersecting, 1u);
}

}  // namespace
}  // namespace graze

#include <graze/engine/mesh/pair_memory.h>
#include <gtest/gtest.h>

#include "tests/narrowphase/simd_targets.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

/// How a body goes on in each step.
struct Course {
  Eigen::Vector3d shift;
  Eigen::Vector3d turn;  // its axis, times the angle
  int steps;
};

Pose stepped(const Pose& pose, const Course& course) {
  Pose next = pose;
  const double angle = course.turn.norm();
  if (angle > 0)
    next.linear() = (Eigen::AngleAxisd(angle, course.turn / angle) * pose.linear()).eval();
  next.linear() = Eigen::Quaterniond(next.linear()).normalized().toRotationMatrix();
  next.translation() += course.shift;
  return next;
}

/// Straight on, back, aside, slower and faster by a great deal, turning, and at rest.
std::vector<Course> courses(double step) {
  const Eigen::Vector3d x = step * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d y = step * Eigen::Vector3d::UnitY();
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  return {{x, none, 20},     {-x, none, 12},    {x + y, none, 6},      {1e-9 * x, none, 4},
          {y, none, 8},      {none, none, 3},   {x, y + 0.5 * x, 20},  {none, -2 * y, 12},
          {10 * y, none, 3}, {-y, 0.1 * x, 12}, {1e-300 * x, none, 2}, {-x, none, 10}};
}

/// All pairs along these courses, with one memory for all of them.
void expect_same_along(const Mesh& mesh_a, const Mesh& mesh_b, Pose pose, double step,
                       bool is_a_moved) {
  PairMemory memory;
  Pose pose_a = Pose::Identity();
  std::size_t pairs = 0;
  for (const Course& course : courses(step)) {
    for (int i = 0; i < course.steps; ++i) {
      const PlacedMesh a{mesh_a, pose_a};
      const PlacedMesh b{mesh_b, pose};
      const TrianglePairs expected = find_triangle_pairs(a, b);
      EXPECT_TRUE(find_triangle_pairs(a, b, memory).pairs == expected.pairs);
      pairs += expected.size();
      Pose& moved = is_a_moved ? pose_a : pose;
      moved = stepped(moved, course);
    }
  }
  EXPECT_GT(pairs, 1000u);
}

TEST(Law9, AMemoryKeepsToACourseAndLeavesIt) {
  const Mesh torus = tests::make_torus(1, 0.3, 60, 30);
  const Mesh ball = tests::make_sphere(0.4, 30, 30);
  Pose pose = Pose::Identity();
  pose.translation() << 0.85, 0.1, 0.05;
  for (const double step : {0.001, 0.01}) {
    expect_same_along(torus, ball, pose, step, false);
    expect_same_along(ball, torus, pose.inverse(), step, true);
  }
  RandomSource source(41);
  const Mesh soup = tests::random_soup({.count = 1500, .extent = 1, .size = 0.15}, source);
  expect_same_along(soup, soup, tests::random_pose(0.3, source), 0.003, false);
}

TEST(Law8, AMemoryKeepsToACourseOnAnyTarget) {
  const Mesh torus = tests::make_torus(1, 0.3, 30, 16);
  const Mesh ball = tests::make_sphere(0.4, 14, 14);
  Pose pose = Pose::Identity();
  pose.translation() << 0.85, 0.1, 0.05;
  for (const std::int64_t target : narrowphase::simd_targets()) {
    narrowphase::force_simd_target(target);
    expect_same_along(torus, ball, pose, 0.004, false);
  }
  narrowphase::force_simd_target(0);
}

/// What moves along itself touches the same planes for ever: flat faces, of which corners and edges
/// lie in each other's planes.
TEST(Law9, AMemoryOfFacesThatSlide) {
  const Mesh box = tests::make_box({1, 1, 1});
  PairMemory memory;
  std::size_t pairs = 0;
  for (const double lift : {0.0, 1e-12, -1e-12, 0.25}) {
    Pose pose = Pose::Identity();
    pose.translation() << -0.5, 0.25, 2 + lift;
    for (int i = 0; i < 40; ++i) {
      const TrianglePairs expected = find_triangle_pairs({box}, {box, pose});
      EXPECT_EQ(find_triangle_pairs({box}, {box, pose}, memory).pairs, expected.pairs) << lift;
      pairs += expected.size();
      pose.translation().x() += 0.0625;
    }
  }
  EXPECT_GT(pairs, 100u);
}

}  // namespace
}  // namespace graze

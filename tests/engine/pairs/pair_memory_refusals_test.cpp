// With a memory the same input is refused as without, wherever the memory last had the meshes.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/pair_memory.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/shapes/formula_meshes.h"

namespace graze {
namespace {

/// Law 10 holds for a pose that follows one that was let in.
TEST(Law10, AMemoryIsNoWayRoundTheDoor) {
  const Mesh box = tests::make_box({1, 1, 1});
  PairMemory memory;
  Pose pose = Pose::Identity();
  pose.translation().x() = 10;
  EXPECT_FALSE(intersects({box}, {box, pose}, memory));
  EXPECT_FALSE(intersects({box}, {box, pose}, memory));
  EXPECT_EQ(memory.still_apart(), 1u);
  Pose bent = pose;
  bent.linear()(0, 0) = 1.1;
  for (int i = 0; i < 2; ++i) {
    EXPECT_THROW(intersects({box}, {box, bent}, memory), PoseError);
    EXPECT_THROW(distance({box, bent}, {box, pose}, memory), PoseError);
  }
  for (int i = 0; i < 16; ++i) {
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
      Pose broken = pose;
      broken.data()[i] = bad;
      EXPECT_THROW(intersects({box}, {box, broken}, memory), PoseError) << i;
      EXPECT_THROW(intersects({box}, {box, broken}, memory), PoseError) << i;
      EXPECT_FALSE(intersects({box}, {box, pose}, memory));
    }
  }
  EXPECT_THROW(within({box}, {box, pose}, -1, memory), InputError);
  EXPECT_THROW(distance({box}, {box, pose}, memory, {.hint = TrianglePair{99, 0}}), InputError);
  EXPECT_FALSE(intersects({box}, {box, pose}, memory));
}

/// Turned, its corners are no doubles.
TEST(Law10, AMemoryOfAMeshThatOverflows) {
  const Mesh vast = tests::make_box({1.5e308, 1.5e308, 1.5e308});
  const Mesh box = tests::make_box({1, 1, 1});
  const Pose turned(Eigen::AngleAxisd(0.25 * EIGEN_PI, Eigen::Vector3d::UnitZ()));
  PairMemory memory;
  EXPECT_THROW(intersects({box}, {vast, turned}), PoseError);
  EXPECT_THROW(intersects({box}, {vast, turned}, memory), PoseError);
  EXPECT_THROW(intersects({vast, turned}, {box}, memory), PoseError);
}

}  // namespace
}  // namespace graze

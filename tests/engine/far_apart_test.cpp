#include <graze/bvh/error.h>
#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using tests::distorted;
using tests::random_pose;

bool are_far(const PlacedMesh& a, const PlacedMesh& b) {
  return are_surely_far_apart({a.pose, MeshAccess::data(a.mesh).ball},
                              {b.pose, MeshAccess::data(b.mesh).ball});
}

/// A mesh whose vertex 0 is further from the middle of its bounds than the others, along `way`,
/// which is one of the rows of its pose stretched to the full deviation.
Mesh needle(double size, const Eigen::Vector3d& way) {
  const Eigen::Vector3d tip = size * way, side = 0.01 * size * way.unitOrthogonal();
  return Mesh({{tip, -tip, side}}, std::vector<TriangleIndices>{{0, 1, 2}});
}

/// Stretched by `deviation` along its own axis x, which points at `way`.
Pose stretched_towards(const Eigen::Vector3d& way, double deviation) {
  Pose pose = Pose::Identity();
  const Eigen::Vector3d second = way.unitOrthogonal();
  pose.linear().col(0) = (1 + deviation / 2) * way;
  pose.linear().col(1) = second;
  pose.linear().col(2) = way.cross(second);
  return pose;
}

// Tips that meet: nothing is nearer than the balls, stretched as far as a pose may be and rounded
// far from the origin. The tips lie on each other, bit for bit or nearly.
TEST(Law9FarApart, NeverOfPointsThatMeet) {
  RandomSource source(1);
  int met = 0;
  for (int n = 0; n < 40000; ++n) {
    const double size = std::pow(10, source.uniform(-200, 60));
    const double other_size = n % 3 == 0 ? size : size * std::pow(10, source.uniform(-12, 0));
    const double way_off = n % 2 == 0 ? 0 : size * std::pow(10, source.uniform(0, 18));
    const Eigen::Vector3d way = source.vector(-1, 1).normalized();
    const double deviation = n % 5 == 0 ? 0 : 0.99e-6;
    PlacedMesh a{needle(size, {1, 0, 0}), stretched_towards(way, deviation)};
    PlacedMesh b{needle(other_size, {1, 0, 0}), stretched_towards(-way, deviation)};
    a.pose.translation() = way_off * source.vector(-1, 1);
    const Eigen::Vector3d tip = place(a.pose, a.mesh.vertices()[0]);
    b.pose.translation() = tip - b.pose.linear() * b.mesh.vertices()[0];
    if (place(b.pose, b.mesh.vertices()[0]) != tip) continue;
    ++met;
    ASSERT_FALSE(are_far(a, b)) << size << ' ' << other_size << ' ' << way_off;
    ASSERT_FALSE(are_far(b, a)) << size << ' ' << other_size << ' ' << way_off;
    ASSERT_TRUE(intersects(a, b));
  }
  EXPECT_GT(met, 8000);
}

// A little further it is sure, at every scale where squares neither overflow nor underflow.
TEST(FarApart, OfWhatIsALittleFurtherApart) {
  RandomSource source(2);
  for (const double scale : {0x1p-480, 1e-100, 1.0, 1e100, 0x1p500}) {
    const Mesh ball = tests::make_sphere(scale, 20, 20);
    for (int n = 0; n < 200; ++n) {
      Pose pose_a = random_pose(scale, source), pose_b = random_pose(0, source);
      const Eigen::Vector3d way = source.vector(-1, 1).normalized();
      const double radii = 2 * MeshAccess::data(ball).ball.radius;
      pose_b.translation() = pose_a.translation() + (1 + 0x1p-17) * radii * way;
      EXPECT_TRUE(are_far({ball, pose_a}, {ball, pose_b})) << scale;
      Work work;
      EXPECT_FALSE(intersects({ball, pose_a}, {ball, pose_b}, &work));
      EXPECT_TRUE(find_triangle_pairs({ball, pose_a}, {ball, pose_b}, {}, &work).pairs.empty());
      EXPECT_EQ(work.trees_built, 0u);
      EXPECT_EQ(work.volume_rejections, 2u);
    }
  }
}

TEST(FarApart, OfMeshesAtTheEndOfTheRangeNothingIsSure) {
  const Mesh huge = tests::make_sphere(0x1p1001, 8, 8), tiny = tests::make_sphere(0x1p-1060, 8, 8);
  Pose pose = Pose::Identity();
  pose.translation().x() = 0x1p1010;
  EXPECT_FALSE(are_far({huge}, {huge, pose}));
  EXPECT_FALSE(intersects({huge}, {huge, pose}));
  pose.translation().x() = 0x1p-1050;
  EXPECT_FALSE(are_far({tiny}, {tiny, pose}));
  EXPECT_FALSE(intersects({tiny}, {tiny, pose}));
}

// Each number of either pose is spoilt.
TEST(Law10FarApart, OnlyOfPosesThatAreLetIn) {
  const Mesh ball = tests::make_sphere(1, 8, 8);
  Pose far = Pose::Identity();
  far.translation().x() = 100;
  ASSERT_TRUE(are_far({ball}, {ball, far}));
  const auto expect_refused = [&](const Pose& bad, int i) {
    Pose moved = bad;
    EXPECT_FALSE(are_far({ball, moved}, {ball, far})) << i;
    EXPECT_FALSE(are_far({ball, far}, {ball, moved})) << i;
    EXPECT_THROW(intersects({ball, moved}, {ball, far}), PoseError) << i;
    EXPECT_THROW(intersects({ball, far}, {ball, moved}), PoseError) << i;
    EXPECT_THROW(find_triangle_pairs({ball, far}, {ball, moved}), PoseError) << i;
  };
  for (int i = 0; i < 16; ++i) {
    for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
      Pose bad = Pose::Identity();
      bad.data()[i] = value;
      expect_refused(bad, i);
    }
    Pose off = Pose::Identity();
    off.data()[i] += i % 4 == 3 ? 0x1p-52 : i < 12 ? 3 * kMaxRotationDeviation : HUGE_VAL;
    expect_refused(off, i);
    Pose mirrored = Pose::Identity();
    mirrored.data()[i % 3 * 5] = -1;
    expect_refused(mirrored, i);
  }
}

}  // namespace
}  // namespace graze

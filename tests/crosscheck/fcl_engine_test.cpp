// That FCL is asked the question that graze is asked: without these, a cross-check that agrees
// would say little.

#include <graze/engine/compare/fcl_engine.h>
#include <graze/engine/compare/referee.h>
#include <graze/engine/mesh/placement.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/shapes/formula_meshes.h"

namespace graze::compare {
namespace {

Pose shifted(double x, double y, double z) {
  Pose pose = Pose::Identity();
  pose.translation() << x, y, z;
  return pose;
}

std::vector<TrianglePair> find_by_referee(const Mesh& mesh_a, const Pose& pose_a,
                                          const Mesh& mesh_b, const Pose& pose_b) {
  std::vector<TrianglePair> pairs;
  for (std::uint32_t a = 0; a < mesh_a.triangles().size(); ++a) {
    for (std::uint32_t b = 0; b < mesh_b.triangles().size(); ++b) {
      if (referee_intersects(place(pose_a, mesh_a.triangle(a)),
                             place(pose_b, mesh_b.triangle(b)))) {
        pairs.push_back({a, b});
      }
    }
  }
  return pairs;
}

TEST(FclEngine, ItsIndicesAreTheMeshs) {
  // Triangle i of the row is met by triangle i + 3 of the other, 30 metres back, and by no other.
  constexpr int kCount = 40;
  const Mesh row = tests::make_row(kCount);
  Pose tilted = shifted(-30 + 0.25, 0.25, -0.5);
  tilted.linear() = Eigen::AngleAxisd(-0.5 * EIGEN_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  tilted.translation().z() = 0.5;
  const FclMesh fcl(row);
  const std::vector<TrianglePair> pairs = find_triangle_pairs(fcl, Pose::Identity(), fcl, tilted);
  ASSERT_EQ(pairs.size(), kCount - 3u);
  for (std::uint32_t i = 0; i < pairs.size(); ++i)
    EXPECT_EQ(pairs[i], (TrianglePair{i, i + 3}));
}

TEST(FclEngine, FindsAllPairsSortedAndOnce) {
  const Mesh sphere = tests::make_sphere(1, 6, 9);
  const Mesh torus = tests::make_torus(1, 0.3, 12, 7);
  const Pose pose_a = shifted(0.125, 1, -2);
  Pose pose_b = shifted(0.7, 1.2, -2.1);
  pose_b.linear() =
      Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const FclMesh fcl_a(sphere);
  const FclMesh fcl_b(torus);
  const std::vector<TrianglePair> pairs = find_triangle_pairs(fcl_a, pose_a, fcl_b, pose_b);
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
  EXPECT_GT(pairs.size(), 20u);
  EXPECT_EQ(pairs, find_by_referee(sphere, pose_a, torus, pose_b));
  EXPECT_TRUE(intersects(fcl_a, pose_a, fcl_b, pose_b));
}

TEST(FclEngine, MeshesThatAreApartHaveNoPairs) {
  const FclMesh sphere(tests::make_sphere(1, 6, 9));
  EXPECT_FALSE(intersects(sphere, Pose::Identity(), sphere, shifted(2.5, 0, 0)));
  EXPECT_TRUE(find_triangle_pairs(sphere, Pose::Identity(), sphere, shifted(2.5, 0, 0)).empty());
  // Surfaces only, as for graze: one wholly inside the other does not touch it.
  const FclMesh small(tests::make_sphere(0.25, 6, 9));
  EXPECT_FALSE(intersects(sphere, Pose::Identity(), small, Pose::Identity()));
}

}  // namespace
}  // namespace graze::compare

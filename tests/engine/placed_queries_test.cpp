// What lies inside a placed mesh, and which voxels it touches: beside a mesh whose vertices are
// placed one by one (law 1), as rational rays and exact triangle tests see it.

#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/voxels.h>
#include <graze/narrowphase/triangle_box.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/engine/rational_containment.h"
#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

Mesh placed_by_hand(const Mesh& mesh, const Pose& pose) {
  std::vector<Eigen::Vector3d> vertices;
  for (const Eigen::Vector3d& vertex : mesh.vertices())
    vertices.push_back(place(pose, vertex));
  return {vertices, mesh.triangles()};
}

TEST(Law1Containment, OfPlacedMeshes) {
  RandomSource source(11);
  int inside = 0, outside = 0;
  for (int n = 0; n < 60; ++n) {
    const Mesh mesh = n % 2 == 0 ? tests::random_tetrahedra(1 + n % 5, 1, source)
                                 : tests::lattice_tetrahedra(1 + n % 5, 2, source);
    const Pose pose = n % 3 == 0 ? tests::at(3, -2, 1) : tests::random_pose(2, source);
    const Mesh there = placed_by_hand(mesh, pose);
    const PlacedMesh placed{mesh, pose};
    for (int i = 0; i < 30; ++i) {
      const Triangle t = there.triangle(static_cast<std::size_t>(source.integer(0, 3)));
      const Eigen::Vector3d random = place(pose, Eigen::Vector3d(source.vector(-1, 1)));
      const Eigen::Vector3d point = i % 3 == 0 ? t.a : i % 3 == 1 ? random : (t.a + t.b) / 2;
      const bool expected = oracle::contains_by_slanted_ray(there, point);
      ++(expected ? inside : outside);
      ASSERT_EQ(contains(placed, point), expected) << n << ": " << point.transpose();
    }
  }
  EXPECT_GT(inside, 300);
  EXPECT_GT(outside, 100);
}

TEST(Law1Voxels, OfPlacedMeshes) {
  RandomSource source(12);
  const Mesh torus = tests::make_torus(1, 0.4, 16, 8);
  for (int n = 0; n < 4; ++n) {
    const Pose pose = tests::random_pose(3, source);
    const Mesh there = placed_by_hand(torus, pose);
    for (const VoxelFill fill : {VoxelFill::Surface, VoxelFill::Solid}) {
      const VoxelSettings settings{.resolution = 12, .fill = fill};
      const Voxels found = find_voxels({torus, pose}, settings);
      EXPECT_EQ(found, find_voxels({there}, settings));
      ASSERT_FALSE(found.empty());
    }
    const Voxels surface = find_voxels({torus, pose}, {.resolution = 12});
    for (const Voxel& voxel : surface) {
      bool touches = false;
      for (std::size_t i = 0; i < there.triangles().size(); ++i)
        touches |= intersects(there.triangle(i), surface.grid.box(voxel));
      ASSERT_TRUE(touches);
    }
  }
}

TEST(Law10Containment, PosesThatAreRefused) {
  const Mesh box = tests::make_box({1, 1, 1});
  Pose skewed = Pose::Identity();
  skewed.matrix()(0, 1) = 0.1;
  EXPECT_THROW(contains({box, skewed}, {0, 0, 0}), PoseError);
  EXPECT_THROW(find_voxels({box, skewed}), PoseError);
  EXPECT_THROW(contains({box, tests::at(std::numeric_limits<double>::infinity())}, {0, 0, 0}),
               PoseError);
}

}  // namespace
}  // namespace graze

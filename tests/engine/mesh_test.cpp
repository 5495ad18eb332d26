#include <graze/bvh/tree/tree.h>
#include <graze/bvh/tree/validate.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/work.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/shapes/formula_meshes.h"

namespace graze {
namespace {

const std::vector<Eigen::Vector3d> kCorners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};

std::string message_of(std::span<const Eigen::Vector3d> vertices,
                       std::span<const Eigen::Vector3i> triangles) {
  try {
    Mesh(vertices, triangles);
  } catch (const MeshError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Law10Mesh, EveryElementIsChecked) {
  const std::vector<Eigen::Vector3i> good{{0, 1, 2}};
  EXPECT_EQ(message_of(kCorners, good), "accepted");
  EXPECT_EQ(message_of(kCorners, {}), "no triangles");
  EXPECT_EQ(message_of({}, good), "triangle 0: index 0 is out of range, there are 0 vertices");
  EXPECT_EQ(message_of(kCorners, std::vector<Eigen::Vector3i>{{0, 1, 2}, {1, 4, 2}}),
            "triangle 1: index 4 is out of range, there are 4 vertices");
  EXPECT_EQ(message_of(kCorners, std::vector<Eigen::Vector3i>{{0, -1, 2}}),
            "triangle 0: index -1 is out of range, there are 4 vertices");
  for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    std::vector<Eigen::Vector3d> vertices = kCorners;
    vertices[3].z() = bad;
    EXPECT_EQ(message_of(vertices, good), "vertex 3: a coordinate is not finite")
        << "unused ones too";
  }
}

TEST(Mesh, KeepsWhatItWasGiven) {
  const std::vector<TriangleIndices> triangles{{2, 1, 0}};
  const Mesh mesh(kCorners, triangles);
  EXPECT_EQ(mesh.vertices().size(), 4u);
  EXPECT_EQ(mesh.triangles()[0], (TriangleIndices{2, 1, 0}));
  EXPECT_EQ(mesh.triangle(0).a, kCorners[2]);
  EXPECT_EQ(mesh.bounds().max, Eigen::Vector3d(1, 1, 0)) << "unused vertices do not count";
}

TEST(Mesh, CopiesShareTheTreeWhichIsBuiltOnce) {
  const Mesh mesh = tests::make_sphere(1, 20, 20);
  const Mesh copy = mesh;
  EXPECT_TRUE(copy == mesh);
  EXPECT_FALSE(copy == tests::make_sphere(1, 20, 20));
  Work work;
  const bvh::Tree& tree = tree_of(copy, &work);
  EXPECT_EQ(work.trees_built, 1u);
  EXPECT_EQ(&tree_of(mesh, &work), &tree);
  EXPECT_EQ(work.trees_built, 1u);
}

TEST(Mesh, TheTreeHoldsItsTriangles) {
  const Mesh mesh = tests::make_torus(2, 0.5, 40, 20);
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const Triangle t = mesh.triangle(i);
    boxes.push_back({t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)});
  }
  EXPECT_EQ(bvh::find_broken_invariant(tree_of(mesh), boxes).value_or(""), "");
}

}  // namespace
}  // namespace graze

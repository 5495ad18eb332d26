#include <graze/engine/mesh/mesh.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/shapes/formula_meshes.h"

namespace graze {
namespace {

TEST(Topology, OfABox) {
  const Topology topology = tests::make_box({1, 2, 3}).topology();
  EXPECT_TRUE(topology.is_closed);
  EXPECT_EQ(topology.boundary_edges, 0u);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.welded_vertices, 8u);
  EXPECT_EQ(topology.degenerate_triangles, 0u);
  EXPECT_EQ(topology.duplicate_triangles, 0u);
}

/// The same surface with three vertices of its own for each triangle.
Mesh unwelded(const Mesh& mesh) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
    const Triangle t = mesh.triangle(i);
    vertices.insert(vertices.end(), {t.a, t.b, t.c});
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return Mesh(vertices, triangles);
}

TEST(Topology, WeldsEqualPositions) {
  const Mesh soup = unwelded(tests::make_sphere(1, 8, 8));
  EXPECT_TRUE(soup.topology().is_closed);
  EXPECT_EQ(soup.topology().components, 1u);
  EXPECT_EQ(soup.topology().welded_vertices, tests::make_sphere(1, 8, 8).vertices().size());
}

TEST(Topology, ASignedZeroIsZero) {
  const std::vector<Eigen::Vector3d> vertices{{0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}};
  const std::vector<TriangleIndices> triangles{{0, 1, 2}, {3, 2, 1}};
  const Topology topology = Mesh(vertices, triangles).topology();
  EXPECT_EQ(topology.welded_vertices, 3u);
  EXPECT_TRUE(topology.is_closed) << "two sides of one triangle";
  EXPECT_EQ(topology.duplicate_triangles, 1u);
}

TEST(Topology, OpenPartsDegenerateAndDuplicateTrianglesAreCounted) {
  const std::vector<Eigen::Vector3d> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                              {7, 7, 7}, {8, 8, 8}, {9, 9, 9}};
  const std::vector<TriangleIndices> triangles{
      {0, 1, 2}, {2, 0, 1}, {0, 1, 2}, {3, 4, 5}, {3, 3, 4}};
  const Topology topology = Mesh(vertices, triangles).topology();
  EXPECT_FALSE(topology.is_closed);
  EXPECT_EQ(topology.boundary_edges, 3u + 3u);
  EXPECT_EQ(topology.components, 2u);
  EXPECT_EQ(topology.degenerate_triangles, 2u);
  EXPECT_EQ(topology.duplicate_triangles, 2u);
}

TEST(Topology, DegenerateIsExact) {
  std::vector<Eigen::Vector3d> vertices{{0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}, {0.7, 0.7, 0.7}};
  const std::vector<TriangleIndices> triangles{{0, 1, 2}};
  EXPECT_EQ(Mesh(vertices, triangles).topology().degenerate_triangles, 1u);
  vertices[1].x() += 1e-17 * 6;
  EXPECT_EQ(Mesh(vertices, triangles).topology().degenerate_triangles, 0u);
}

}  // namespace
}  // namespace graze

// Needles, duplicates, and triangles without area, against the referee.

#include <graze/engine/compare/referee.h>
#include <graze/engine/mesh/pair.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/shapes/random_meshes.h"
#include "tests/stress/sweeps.h"

namespace graze::stress {
namespace {

void check_needles(std::size_t cases) {
  for (const SweepRow& row : sweep_needles(cases)) {
    EXPECT_EQ(row.cases, cases);
    EXPECT_EQ(row.wrong, 0u) << row.value;
    EXPECT_GT(row.hits, cases / 50) << row.value;
    EXPECT_LT(row.hits, cases - cases / 50) << row.value;
  }
}

TEST(StressTriangles, NeedlesOfAspectsToTenToTheFifteenth) {
  check_needles(800);
}

TEST(StressTrianglesSlow, NeedlesOfAspectsToTenToTheFifteenth) {
  check_needles(200000);
}

/// The mesh with each triangle `times` times.
Mesh repeated(const Mesh& mesh, int times) {
  std::vector<TriangleIndices> triangles;
  for (const TriangleIndices& t : mesh.triangles())
    triangles.insert(triangles.end(), static_cast<std::size_t>(times), t);
  return Mesh(mesh.vertices(), triangles);
}

TEST(StressTriangles, DuplicatesCountEachForItself) {
  RandomSource source(2);
  for (int n = 0; n < 20; ++n) {
    const Mesh a = tests::lattice_soup(40, 3, source);
    const Mesh b = tests::lattice_soup(40, 3, source);
    const std::size_t pairs = find_triangle_pairs({a}, {b}).size();
    const TrianglePairs many = find_triangle_pairs({repeated(a, 20)}, {repeated(b, 3)});
    ASSERT_EQ(many.size(), 60 * pairs);
  }
}

TEST(StressTriangles, SegmentsAndPointsOnATriangleAreHits) {
  RandomSource source(3);
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> flat;
  for (std::uint32_t i = 0; i < 300; ++i) {
    for (int k = 0; k < 3; ++k)
      vertices.push_back(source.vector(-1, 1));
    flat.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  std::vector<TriangleIndices> without_area;
  for (std::uint32_t i = 0; i < 300; ++i) {
    without_area.push_back({3 * i, 3 * i, 3 * i + 1});
    without_area.push_back({3 * i + 2, 3 * i + 2, 3 * i + 2});
  }
  const Mesh whole(vertices, flat);
  const Mesh parts(vertices, without_area);
  const TrianglePairs found = find_triangle_pairs({whole}, {parts});
  for (std::uint32_t i = 0; i < 300; ++i) {
    EXPECT_TRUE(std::binary_search(found.begin(), found.end(), TrianglePair{i, 2 * i}));
    EXPECT_TRUE(std::binary_search(found.begin(), found.end(), TrianglePair{i, 2 * i + 1}));
  }
  for (const TrianglePair& pair : found)
    ASSERT_TRUE(compare::referee_intersects(whole.triangle(pair.a), parts.triangle(pair.b)));
  const TrianglePairs crossing = find_triangle_pairs({whole}, {parts}, {.touch = Touch::Exclude});
  EXPECT_GT(crossing.size(), 100u) << "segments that pierce others";
  for (const TrianglePair& pair : crossing)
    ASSERT_NE(pair.a, pair.b / 2) << "an edge does not cross its triangle";
}

}  // namespace
}  // namespace graze::stress

// Needles, duplicates, and triangles without area, against the referee.

#include <graze/engine/compare/referee.h>
#include <graze/engine/mesh/pair.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/shapes/random_meshes.h"

namespace graze::stress {
namespace {

/// A triangle of length 1 and `width`, its corners rounded.
Triangle needle(double width, RandomSource& source) {
  const Eigen::Vector3d from = source.vector(-1, 1);
  const Eigen::Vector3d along = source.vector(-1, 1).normalized();
  const Eigen::Vector3d across = along.cross(source.vector(-1, 1)).normalized() * width;
  return {from, from + along, from + source.uniform(0, 1) * along + across};
}

/// The triangle moved so that a point of its long edge falls on a point of the other's.
Triangle brought_to(const Triangle& t, const Triangle& other, RandomSource& source) {
  const double u = source.uniform(0, 1);
  const double v = source.uniform(0, 1);
  const Eigen::Vector3d by = other.a + u * (other.b - other.a) - (t.a + v * (t.b - t.a));
  return {t.a + by, t.b + by, t.c + by};
}

void check_needles(int count) {
  RandomSource source(1);
  int hits = 0;
  int total = 0;
  for (const double width : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-17}) {
    for (int n = 0; n < count; ++n) {
      const Triangle a = needle(width, source);
      const Triangle b = brought_to(needle(n % 2 == 0 ? width : 0.5, source), a, source);
      const bool truth = compare::referee_intersects(a, b);
      ASSERT_EQ(intersects(a, b), truth) << width << ' ' << n;
      ASSERT_EQ(intersects(b, a), truth) << width << ' ' << n;
      hits += truth;
      ++total;
    }
  }
  EXPECT_GT(hits, total / 20);
  EXPECT_LT(hits, total - total / 20);
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
    const TrianglePairs many = find_triangle_pairs({repeated(a, 50)}, {repeated(b, 3)});
    ASSERT_EQ(many.size(), 150 * pairs);
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

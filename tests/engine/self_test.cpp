#include <graze/engine/mesh/self.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

TEST(Self, CleanSurfacesHaveNeighboursOnly) {
  for (const Mesh& mesh : {tests::make_sphere(1, 16, 16), tests::make_torus(2, 0.5, 20, 12),
                           tests::make_box({1, 1, 1})}) {
    EXPECT_FALSE(self_intersects(mesh));
    EXPECT_TRUE(find_self_pairs(mesh).empty());
    EXPECT_GT(find_self_pairs(mesh, {.kind = SelfPairKind::Neighbour}).size(),
              mesh.triangles().size());
  }
}

// Law 9: both kinds together are the pairs that meet, and each pair is of one kind.
TEST(Law9Self, BothKindsTogetherAreBruteForce) {
  RandomSource source(1);
  std::size_t crossings = 0, neighbours = 0;
  for (int n = 0; n < 40; ++n) {
    const Mesh mesh =
        n % 2 == 0 ? tests::lattice_soup(60, 2, source) : tests::random_soup({.count = 80}, source);
    std::vector<TrianglePair> expected;
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
      for (std::uint32_t j = i + 1; j < mesh.triangles().size(); ++j) {
        if (intersects(mesh.triangle(i), mesh.triangle(j))) expected.push_back({i, j});
      }
    }
    const TrianglePairs crossing = find_self_pairs(mesh);
    const TrianglePairs neighbour = find_self_pairs(mesh, {.kind = SelfPairKind::Neighbour});
    std::vector<TrianglePair> all;
    std::merge(crossing.begin(), crossing.end(), neighbour.begin(), neighbour.end(),
               std::back_inserter(all));
    EXPECT_EQ(all, expected);
    EXPECT_EQ(self_intersects(mesh), !crossing.empty());
    for (const Volume volume : kVolumes) {
      EXPECT_EQ(find_self_pairs(mesh, {.volume = volume}).pairs, crossing.pairs) << name_of(volume);
      EXPECT_EQ(self_intersects(mesh, {.volume = volume}), !crossing.empty()) << name_of(volume);
    }
    crossings += crossing.size();
    neighbours += neighbour.size();
  }
  EXPECT_GT(crossings, 1000u);
  EXPECT_GT(neighbours, 500u);
}

SelfPairKind kind_of(const std::vector<Eigen::Vector3d>& vertices,
                     const std::vector<TriangleIndices>& triangles) {
  const Mesh mesh(vertices, triangles);
  const bool is_crossing = self_intersects(mesh);
  EXPECT_EQ(find_self_pairs(mesh, {.kind = SelfPairKind::Neighbour}).size(), is_crossing ? 0u : 1u);
  return is_crossing ? SelfPairKind::Crossing : SelfPairKind::Neighbour;
}

TEST(Self, KindsAreToldApartByWhatIsShared) {
  const Eigen::Vector3d o(0, 0, 0), x(4, 0, 0), y(0, 4, 0), z(0, 0, 4), in(1, 1, 0), far(-4, -4, 0);
  EXPECT_EQ(kind_of({o, x, y, z}, {{0, 1, 2}, {0, 1, 3}}), SelfPairKind::Neighbour) << "an edge";
  EXPECT_EQ(kind_of({o, x, y, z}, {{0, 1, 2}, {0, 3, 3}}), SelfPairKind::Neighbour) << "a vertex";
  EXPECT_EQ(kind_of({o, x, y, in}, {{0, 1, 2}, {0, 1, 3}}), SelfPairKind::Crossing)
      << "folded flat";
  EXPECT_EQ(kind_of({o, x, y, far}, {{0, 1, 2}, {0, 1, 3}}), SelfPairKind::Neighbour)
      << "unfolded flat";
  EXPECT_EQ(kind_of({o, x, y, in, z}, {{0, 1, 2}, {0, 3, 4}}), SelfPairKind::Crossing)
      << "edge in the face";
  EXPECT_EQ(kind_of({o, x, y}, {{0, 1, 2}, {2, 1, 0}}), SelfPairKind::Crossing)
      << "the same triangle twice";
  EXPECT_EQ(kind_of({o, x, y, o, x, z}, {{0, 1, 2}, {3, 4, 5}}), SelfPairKind::Neighbour)
      << "welded";
  EXPECT_EQ(kind_of({o, x, y, z}, {{0, 1, 2}, {0, 0, 1}}), SelfPairKind::Neighbour)
      << "an edge as a triangle";
  EXPECT_EQ(kind_of({o, x}, {{0, 0, 1}, {0, 0, 1}}), SelfPairKind::Neighbour)
      << "an edge twice: a vertex that both repeat is shared once";
  EXPECT_EQ(kind_of({o, x}, {{0, 0, 0}, {0, 0, 0}}), SelfPairKind::Neighbour) << "a vertex twice";
}

TEST(Self, LimitsSaySo) {
  RandomSource source(3);
  const Mesh mesh = tests::lattice_soup(60, 2, source);
  const TrianglePairs some = find_self_pairs(mesh, {.limit = 7});
  EXPECT_EQ(some.size(), 7u);
  EXPECT_EQ(some.completeness, Completeness::LimitReached);
}

}  // namespace
}  // namespace graze

#include <graze/engine/mesh/self.h>
#include <graze/narrowphase/triangle_pair/adjacent_triangles.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

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
  const bool is_intersecting = self_intersects(mesh);
  EXPECT_EQ(find_self_pairs(mesh, {.kind = SelfPairKind::Neighbour}).size(),
            is_intersecting ? 0u : 1u);
  return is_intersecting ? SelfPairKind::Intersecting : SelfPairKind::Neighbour;
}

TEST(Self, KindsAreToldApartByWhatIsShared) {
  const Eigen::Vector3d o(0, 0, 0), x(4, 0, 0), y(0, 4, 0), z(0, 0, 4), in(1, 1, 0), far(-4, -4, 0);
  EXPECT_EQ(kind_of({o, x, y, z}, {{0, 1, 2}, {0, 1, 3}}), SelfPairKind::Neighbour) << "an edge";
  EXPECT_EQ(kind_of({o, x, y, z}, {{0, 1, 2}, {0, 3, 3}}), SelfPairKind::Neighbour) << "a vertex";
  EXPECT_EQ(kind_of({o, x, y, in}, {{0, 1, 2}, {0, 1, 3}}), SelfPairKind::Intersecting)
      << "folded flat";
  EXPECT_EQ(kind_of({o, x, y, far}, {{0, 1, 2}, {0, 1, 3}}), SelfPairKind::Neighbour)
      << "unfolded flat";
  EXPECT_EQ(kind_of({o, x, y, in, z}, {{0, 1, 2}, {0, 3, 4}}), SelfPairKind::Intersecting)
      << "edge in the face";
  EXPECT_EQ(kind_of({o, x, y}, {{0, 1, 2}, {2, 1, 0}}), SelfPairKind::Intersecting)
      << "the same triangle twice";
  EXPECT_EQ(kind_of({o, x, y, o, x, z}, {{0, 1, 2}, {3, 4, 5}}), SelfPairKind::Neighbour)
      << "welded";
  EXPECT_EQ(kind_of({o, x, y, z}, {{0, 1, 2}, {0, 0, 1}}), SelfPairKind::Neighbour)
      << "an edge as a triangle";
  EXPECT_EQ(kind_of({o, x}, {{0, 0, 1}, {0, 0, 1}}), SelfPairKind::Neighbour)
      << "an edge twice: a vertex that both repeat is shared once";
  EXPECT_EQ(kind_of({o, x}, {{0, 0, 0}, {0, 0, 0}}), SelfPairKind::Neighbour) << "a vertex twice";
}

/// Without any tree, or any look at more than two triangles at a time.
std::vector<TrianglePair> pairs_one_by_one(const Mesh& mesh, SelfPairKind kind) {
  std::vector<TrianglePair> pairs;
  for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
    for (std::uint32_t j = i + 1; j < mesh.triangles().size(); ++j) {
      if (!intersects(mesh.triangle(i), mesh.triangle(j))) continue;
      TriangleIndices a = mesh.triangles()[i], b = mesh.triangles()[j];
      std::size_t shared = 0;  // first in both; what a triangle repeats, once
      for (std::size_t k = 0; k < 3; ++k) {
        const auto at = [&](std::uint32_t corner) { return mesh.welded()[corner]; };
        const auto is_same = [&](std::uint32_t corner) { return at(corner) == at(a[k]); };
        if (std::any_of(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(shared), is_same))
          continue;
        auto* const found = std::find_if(b.begin() + shared, b.end(), is_same);
        if (found == b.end()) continue;
        std::swap(a[k], a[shared]);
        std::swap(*found, b[shared++]);
      }
      const auto placed = [&](const TriangleIndices& t) -> Triangle {
        return {mesh.vertices()[t[0]], mesh.vertices()[t[1]], mesh.vertices()[t[2]]};
      };
      const bool is_intersecting =
          shared == 0 || shared == 3 ||
          (shared == 2 ? narrowphase::intersect_beyond_edge(placed(a), placed(b))
                       : narrowphase::intersect_beyond_vertex(placed(a), placed(b)));
      if (is_intersecting == (kind == SelfPairKind::Intersecting)) pairs.push_back({i, j});
    }
  }
  return pairs;
}

Mesh moved(const Mesh& mesh, double noise, RandomSource& source) {
  std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Eigen::Vector3d& vertex : vertices)
    vertex += noise * source.vector(-1, 1);
  return {std::move(vertices), {mesh.triangles().begin(), mesh.triangles().end()}};
}

/// A tip that `rays` triangles share, which go around it so many times, and half a ray's turn more.
Mesh make_tip(int rays, int turns, double height) {
  std::vector<Eigen::Vector3d> vertices = {{0, 0, height}};
  std::vector<TriangleIndices> triangles;
  for (int i = 0; i < rays; ++i) {
    const double angle = 2 * std::numbers::pi * turns * i / rays;
    vertices.emplace_back(std::cos(angle), std::sin(angle), 0.1 * height * i / rays);
    const auto at = [&](int k) { return static_cast<std::uint32_t>(k % rays + 1); };
    triangles.push_back({0, at(i), at(i + 1)});
  }
  return {std::move(vertices), std::move(triangles)};
}

void expect_one_by_one(const Mesh& mesh, std::size_t& crossings) {
  const std::vector<TrianglePair> crossing = pairs_one_by_one(mesh, SelfPairKind::Intersecting);
  crossings += crossing.size();
  EXPECT_EQ(self_intersects(mesh), !crossing.empty());
  for (const Volume volume : kVolumes) {
    EXPECT_EQ(find_self_pairs(mesh, {.volume = volume}).pairs, crossing) << name_of(volume);
    EXPECT_EQ(find_self_pairs(mesh, {.kind = SelfPairKind::Neighbour, .volume = volume}).pairs,
              pairs_one_by_one(mesh, SelfPairKind::Neighbour))
        << name_of(volume);
  }
}

// Surfaces, most of whose vertices say that what is around them is simple: until noise folds them.
TEST(Law9Self, SurfacesSmoothAndCrumpledAreBruteForce) {
  RandomSource source(7);
  std::size_t crossings = 0;
  for (const double noise : {0.0, 1e-16, 1e-12, 0.01, 0.1, 0.3}) {
    expect_one_by_one(moved(tests::make_sphere(1, 12, 12), noise, source), crossings);
    expect_one_by_one(moved(tests::make_torus(2, 0.5, 20, 10), noise, source), crossings);
    for (const int turns : {1, 2, 3}) {
      expect_one_by_one(moved(make_tip(20, turns, 1), noise, source), crossings);
      expect_one_by_one(moved(make_tip(7, turns, 0), noise, source), crossings);
    }
  }
  EXPECT_GT(crossings, 500u);
  expect_one_by_one(make_tip(400, 1, 1), crossings);  // more than anybody looks at together
}

// Triangles that others repeat, turn over or fold onto themselves.
TEST(Law9Self, DamagedSurfacesAreBruteForce) {
  RandomSource source(8);
  std::size_t crossings = 0;
  for (int n = 0; n < 20; ++n) {
    const Mesh whole = tests::make_sphere(1, 8, 8);
    std::vector<TriangleIndices> triangles(whole.triangles().begin(), whole.triangles().end());
    std::vector<Eigen::Vector3d> vertices(whole.vertices().begin(), whole.vertices().end());
    const auto any = [&](std::size_t size) {
      return static_cast<std::size_t>(source.integer(0, static_cast<int>(size) - 1));
    };
    for (int k = 0; k < 4; ++k) {
      TriangleIndices& triangle = triangles[any(triangles.size())];
      std::swap(triangle[0], triangle[1]);
      triangles.push_back(triangles[any(triangles.size())]);
      TriangleIndices other = triangles[any(triangles.size())];
      other[any(3)] = static_cast<std::uint32_t>(any(vertices.size()));
      triangles.push_back(other);
      vertices[any(vertices.size())] = vertices[any(vertices.size())];
      triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(any(triangles.size())));
    }
    expect_one_by_one({vertices, triangles}, crossings);
  }
  EXPECT_GT(crossings, 400u);
}

TEST(Self, NeighboursOfASurfaceNeedNoTests) {
  RandomSource source(6);
  for (const Mesh& regular : {tests::make_sphere(1, 60, 60), tests::make_torus(2, 0.5, 80, 40)}) {
    const Mesh mesh = moved(regular, 1e-3, source);  // without what lies in one plane
    Work work;
    EXPECT_TRUE(find_self_pairs(mesh, {}, &work).empty());
    EXPECT_EQ(work.exact_tests, 0u);
    EXPECT_LT(work.triangle_tests, mesh.triangles().size());
    EXPECT_GT(work.filter_tests, mesh.triangles().size());
    Work work_of_neighbours;
    const std::size_t neighbours =
        find_self_pairs(mesh, {.kind = SelfPairKind::Neighbour}, &work_of_neighbours).size();
    EXPECT_GT(neighbours, 5 * mesh.triangles().size());
    EXPECT_EQ(work_of_neighbours.triangle_tests, work.triangle_tests);
  }
}

// Yes or no: of a small mesh, or where much crosses, without looking at all vertices first; where
// a large mesh crosses itself in one place, as well.
TEST(Self, OnePairThatCrossesIsFoundWhereverItIs) {
  RandomSource source(9);
  Work work;
  EXPECT_TRUE(self_intersects(moved(tests::make_sphere(1, 60, 60), 0.2, source), &work));
  EXPECT_EQ(work.filter_tests, 0u);
  EXPECT_FALSE(self_intersects(tests::make_box({1, 1, 1}), &work));
  EXPECT_EQ(work.filter_tests, 0u);
  const Mesh clean = tests::make_sphere(1, 60, 60);
  for (int n = 0; n < 20; ++n) {
    std::vector<Eigen::Vector3d> vertices(clean.vertices().begin(), clean.vertices().end());
    std::vector<TriangleIndices> triangles(clean.triangles().begin(), clean.triangles().end());
    const auto first = static_cast<std::uint32_t>(vertices.size());
    const Eigen::Vector3d way = source.vector(-1, 1).normalized();
    const Eigen::Vector3d across = way.unitOrthogonal();
    for (const double along : {0.95, 1.05})
      vertices.push_back(along * way);
    vertices.push_back(way + 1e-3 * across);
    triangles.push_back({first, first + 1, first + 2});
    Work asked;
    EXPECT_TRUE(self_intersects({vertices, triangles}, &asked));
    EXPECT_FALSE(find_self_pairs({vertices, triangles}).empty());
  }
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

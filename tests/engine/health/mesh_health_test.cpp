// What check() lists, beside what was done to a mesh, and beside the definitions, one by one.

#include <graze/engine/mesh/data/orientation.h>
#include <graze/engine/mesh/mesh_health.h>
#include <graze/engine/mesh/self.h>
#include <graze/print.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

/// Parts that are joined into one mesh.
struct Parts {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;

  void add(const Mesh& mesh, const Eigen::Vector3d& offset, bool is_turned) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const Eigen::Vector3d& vertex : mesh.vertices())
      vertices.push_back(vertex + offset);
    for (TriangleIndices t : mesh.triangles()) {
      if (is_turned) std::swap(t[1], t[2]);
      triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }

  Mesh mesh() const { return {vertices, triangles}; }
};

const Eigen::Vector3d kOrigin = Eigen::Vector3d::Zero();

TEST(MeshHealth, ClosedSurfacesAreHealthy) {
  for (const Mesh& mesh : {tests::make_box({1, 2, 3}), tests::make_sphere(1, 12, 16),
                           tests::make_torus(2, 0.5, 20, 12)}) {
    const MeshHealth health = check(mesh);
    EXPECT_TRUE(health.is_healthy());
    EXPECT_EQ(health, MeshHealth{});
    EXPECT_EQ(health.fault_count(), 0u);
  }
}

TEST(MeshHealth, EachFaultIsNamed) {
  const Mesh box = tests::make_box({1, 1, 1});
  Parts parts;
  parts.add(box, kOrigin, false);
  std::vector<TriangleIndices>& triangles = parts.triangles;

  const TriangleIndices lost = triangles[5];
  triangles.erase(triangles.begin() + 5);
  const MeshHealth open = check(parts.mesh());
  EXPECT_EQ(open.open_edges.size(), 3u);
  EXPECT_EQ(open.fault_count(), 3u);
  for (const FaultyEdge& edge : open.open_edges) {
    EXPECT_EQ(edge.triangle_count, 1u);
    for (const std::uint32_t vertex : edge.vertices)
      EXPECT_EQ(std::count(lost.begin(), lost.end(), vertex), 1);
  }

  triangles.insert(triangles.begin() + 5, {lost[0], lost[2], lost[1]});
  const MeshHealth turned = check(parts.mesh());
  EXPECT_EQ(turned.turned_edges.size(), 3u);
  EXPECT_EQ(turned.fault_count(), 3u);

  triangles[5] = lost;
  triangles.push_back(triangles[3]);
  const MeshHealth twice = check(parts.mesh());
  EXPECT_EQ(twice.duplicate_triangles, (std::vector<DuplicateTriangle>{{12, 3}}));
  EXPECT_EQ(twice.non_manifold_edges.size(), 3u);
  EXPECT_EQ(twice.self_intersections.pairs, (std::vector<TrianglePair>{{3, 12}}));
  EXPECT_EQ(twice.fault_count(), 5u);

  triangles.back() = {0, 1, 1};
  const MeshHealth point = check(parts.mesh());
  EXPECT_EQ(point.degenerate_triangles, (std::vector<std::uint32_t>{12}));
  EXPECT_TRUE(point.open_edges.empty());
  EXPECT_TRUE(point.non_manifold_edges.empty());
}

TEST(MeshHealth, AMeshInsideOutIsFound) {
  Parts parts;
  parts.add(tests::make_torus(2, 0.5, 16, 8), kOrigin, true);
  const MeshHealth health = check(parts.mesh());
  EXPECT_EQ(health.inside_out_parts, (std::vector<InsideOutPart>{{0, 256, 0}}));
  EXPECT_EQ(health.fault_count(), 1u);
}

// Two cubes with an edge in common are two parts: four triangles meet there, and only one is wrong.
TEST(MeshHealth, WhatMeetsAtAnEdgeIsJudgedByItself) {
  Parts parts;
  parts.add(tests::make_box({1, 1, 1}), kOrigin, false);
  parts.add(tests::make_box({1, 1, 1}), {2, 2, 0}, true);
  const MeshHealth health = check(parts.mesh());
  ASSERT_EQ(health.non_manifold_edges.size(), 1u);
  EXPECT_EQ(health.non_manifold_edges[0].triangle_count, 4u);
  EXPECT_EQ(health.inside_out_parts, (std::vector<InsideOutPart>{{12, 12, 0}}));
  EXPECT_TRUE(health.self_intersections.empty());
}

// Two solids that go through each other face outwards both, though a corner of each is inside the
// other.
TEST(MeshHealth, WhatCrossesAPartDoesNotTurnItInsideOut) {
  Parts parts;
  parts.add(tests::make_box({1, 1, 1}), kOrigin, false);
  parts.add(tests::make_box({1, 1, 1}), {0.5, 0.25, 0.125}, false);
  const MeshHealth health = check(parts.mesh());
  EXPECT_FALSE(health.self_intersections.empty());
  EXPECT_TRUE(health.inside_out_parts.empty());
}

TEST(MeshHealth, EdgesInTheListOfTopology) {
  RandomSource source(3);
  for (int n = 0; n < 20; ++n) {
    const Mesh mesh = tests::lattice_soup(60, 2, source);
    const MeshHealth health = check(mesh);
    const auto is_odd = [](const FaultyEdge& edge) { return edge.triangle_count % 2 == 1; };
    EXPECT_EQ(health.open_edges.size() +
                  static_cast<std::size_t>(std::count_if(health.non_manifold_edges.begin(),
                                                         health.non_manifold_edges.end(), is_odd)),
              mesh.topology().boundary_edges);
    EXPECT_EQ(health.degenerate_triangles.size(), mesh.topology().degenerate_triangles);
    EXPECT_EQ(health.duplicate_triangles.size(), mesh.topology().duplicate_triangles);
    EXPECT_EQ(health.self_intersections, find_self_pairs(mesh));
    EXPECT_EQ(health.turned_edges.empty(), !orientation_of(mesh).turned);
  }
}

using Position = std::tuple<double, double, double>;

/// Edges by their positions, with the triangles that go along them up and down.
std::map<std::pair<Position, Position>, std::array<std::set<std::uint32_t>, 2>> edges_by_position(
    const Mesh& mesh) {
  std::map<std::pair<Position, Position>, std::array<std::set<std::uint32_t>, 2>> edges;
  for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
    std::array<Position, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d& p = mesh.vertices()[mesh.triangles()[i][k]];
      corners[k] = {p.x(), p.y(), p.z()};
    }
    if (std::set<Position>(corners.begin(), corners.end()).size() < 3) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const Position &s = corners[k], &t = corners[(k + 1) % 3];
      edges[std::minmax(s, t)][s < t ? 0 : 1].insert(i);
    }
  }
  return edges;
}

TEST(MeshHealth, EdgesAreThoseOfTheDefinition) {
  RandomSource source(5);
  std::size_t faults = 0;
  for (int n = 0; n < 20; ++n) {
    const Mesh mesh = tests::lattice_soup(40, 1, source);
    const MeshHealth health = check(mesh);
    using Fault = std::tuple<Position, Position, std::uint32_t, std::uint32_t>;
    const auto position = [&](std::uint32_t vertex) {
      EXPECT_EQ(mesh.welded()[vertex], vertex);
      const Eigen::Vector3d& p = mesh.vertices()[vertex];
      return Position(p.x(), p.y(), p.z());
    };
    const auto found = [&](const std::vector<FaultyEdge>& list) {
      std::set<Fault> faulty;
      for (const FaultyEdge& edge : list) {
        EXPECT_LT(edge.vertices[0], edge.vertices[1]);
        std::pair ends(position(edge.vertices[0]), position(edge.vertices[1]));
        if (ends.second < ends.first) std::swap(ends.first, ends.second);
        faulty.insert({ends.first, ends.second, edge.triangle, edge.triangle_count});
      }
      EXPECT_EQ(faulty.size(), list.size());
      return faulty;
    };
    std::set<Fault> open, crowded, turned;
    for (const auto& [ends, ways] : edges_by_position(mesh)) {
      const std::size_t up = ways[0].size(), down = ways[1].size(), count = up + down;
      const std::uint32_t lowest = up == 0     ? *ways[1].begin()
                                   : down == 0 ? *ways[0].begin()
                                               : std::min(*ways[0].begin(), *ways[1].begin());
      const Fault fault{ends.first, ends.second, lowest, static_cast<std::uint32_t>(count)};
      if (count == 1) open.insert(fault);
      if (count > 2) crowded.insert(fault);
      if (std::max(up, down) - std::min(up, down) > 1) turned.insert(fault);
    }
    EXPECT_EQ(found(health.open_edges), open);
    EXPECT_EQ(found(health.non_manifold_edges), crowded);
    EXPECT_EQ(found(health.turned_edges), turned);
    faults += open.size() + crowded.size() + turned.size();
  }
  EXPECT_GT(faults, 500u);
}

/// Puts a box into [low, high]^3 and, at random, more beside each other within it; turns some. Says
/// which of them are wrong.
void nest(double low, double high, std::uint32_t depth, RandomSource& source, Parts& parts,
          std::vector<InsideOutPart>& wrong) {
  const double half = (high - low) / 2;
  const bool is_turned = source.integer(0, 1) == 1;
  const auto first = static_cast<std::uint32_t>(parts.triangles.size());
  const Mesh box = tests::make_box(half * Eigen::Vector3d(1, 1, 1));
  parts.add(box, (low + half) * Eigen::Vector3d(1, 1, 1), is_turned);
  if (is_turned != (depth % 2 == 1)) wrong.push_back({first, 12, depth});
  if (depth == 4) return;
  const double eighth = half / 4;
  if (source.integer(0, 3) != 0)
    nest(low + eighth, low + 3 * eighth, depth + 1, source, parts, wrong);
  if (source.integer(0, 3) != 0)
    nest(low + 4 * eighth, low + 7 * eighth, depth + 1, source, parts, wrong);
}

TEST(MeshHealth, NestedPartsFaceByTheirDepth) {
  RandomSource source(11);
  std::size_t deepest = 0, count = 0;
  for (int n = 0; n < 60; ++n) {
    Parts parts;
    std::vector<InsideOutPart> wrong;
    nest(-8, 8, 0, source, parts, wrong);
    const MeshHealth health = check(parts.mesh());
    EXPECT_EQ(health.inside_out_parts, wrong) << n;
    EXPECT_EQ(health.fault_count(), wrong.size()) << n;
    count += wrong.size();
    for (const InsideOutPart& part : wrong)
      deepest = std::max<std::size_t>(deepest, part.depth);
  }
  EXPECT_EQ(deepest, 4u);
  EXPECT_GT(count, 100u);
}

TEST(MeshHealth, IsPrintedByItsCounts) {
  std::ostringstream text;
  text << std::showpos << std::hex << check(tests::make_row(4));
  EXPECT_EQ(text.str(),
            "12 open, 0 non-manifold and 0 turned edges, 0 degenerate and 0 duplicate triangles, "
            "0 parts inside out, 0 self-intersections");
}

TEST(MeshHealth, ProgressGrowsToTheEnd) {
  const Mesh mesh = tests::make_torus(2, 0.5, 100, 50);
  std::vector<std::size_t> done;
  Work work;
  const MeshHealth health = check(mesh,
                                  {.on_progress =
                                       [&](std::size_t count, std::size_t total) {
                                         EXPECT_EQ(total, mesh.triangles().size());
                                         done.push_back(count);
                                       }},
                                  &work);
  EXPECT_TRUE(health.is_healthy());
  EXPECT_GT(done.size(), 100u);
  EXPECT_LT(done.size(), 300u);
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  EXPECT_EQ(done.back(), mesh.triangles().size());
  EXPECT_GT(work.triangle_tests, 0u);
  const auto fail = [](std::size_t, std::size_t) { throw std::runtime_error("enough"); };
  EXPECT_THROW(check(mesh, {.on_progress = fail}), std::runtime_error);
}

}  // namespace
}  // namespace graze

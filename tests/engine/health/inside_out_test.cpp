// Which parts of a surface face the wrong way, where edges of four triangles cut it: beside solids
// of cubes.

#include <graze/engine/mesh/mesh_health.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "tests/shapes/cubes.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using tests::Cell;

/// For each triangle the lowest that it hangs together with by edges of two triangles; and those
/// lowest ones of what is not closed by itself.
std::vector<std::uint32_t> lowest_of_parts(const Mesh& mesh, std::set<std::uint32_t>& cut_off) {
  std::map<std::set<std::uint32_t>, std::vector<std::uint32_t>> edges;
  for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
    const TriangleIndices& t = mesh.triangles()[i];
    for (std::size_t k = 0; k < 3; ++k)
      edges[{t[k], t[(k + 1) % 3]}].push_back(i);
  }
  std::vector<std::uint32_t> lowest(mesh.triangles().size());
  for (std::uint32_t i = 0; i < lowest.size(); ++i)
    lowest[i] = i;
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (const auto& [ends, around] : edges) {
      if (around.size() != 2 || lowest[around[0]] == lowest[around[1]]) continue;
      lowest[around[0]] = lowest[around[1]] = std::min(lowest[around[0]], lowest[around[1]]);
      has_changed = true;
    }
  }
  for (const auto& [ends, around] : edges) {
    for (const std::uint32_t triangle : around) {
      const auto of_part = std::count_if(around.begin(), around.end(), [&](std::uint32_t other) {
        return lowest[other] == lowest[triangle];
      });
      if (of_part % 2 == 1) cut_off.insert(lowest[triangle]);
    }
  }
  return lowest;
}

// Whatever parts edges of four triangles cut a solid's surface into: those that are turned are
// found, and no others.
TEST(InsideOutParts, BetweenEdgesOfFourTrianglesAreJudged) {
  RandomSource source(13);
  std::size_t turned_count = 0, cut_off_count = 0, inner = 0;
  for (int n = 0; n < 300; ++n) {
    std::set<Cell> cells;
    const int size = 2 + n % 3;
    for (int i = 0; i < size * size * size; ++i) {
      if (source.integer(0, 9) < 3 + n % 6)
        cells.insert({i % size, i / size % size, i / size / size});
    }
    if (n % 2 ==
        0) {  // a cube above a hole of a plate: around its lower side all edges are of four
      for (int i = 0; i < 9; ++i)
        cells.insert({i % 3, i / 3, 0});
      cells.erase({1, 1, 0}), cells.insert({1, 1, 1});
    }
    if (cells.empty()) continue;
    const Mesh outward = tests::surface_of_cubes(cells).mesh();
    EXPECT_TRUE(check(outward).inside_out_parts.empty()) << n;
    std::set<std::uint32_t> cut_off;
    const std::vector<std::uint32_t> lowest = lowest_of_parts(outward, cut_off);
    std::map<std::uint32_t, std::uint32_t> counts;
    for (const std::uint32_t part : lowest)
      ++counts[part];
    std::map<std::uint32_t, bool> is_turned;
    for (const auto& [part, count] : counts)
      is_turned[part] = source.integer(0, 2) == 0;
    std::vector<TriangleIndices> triangles(outward.triangles().begin(), outward.triangles().end());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (is_turned[lowest[i]]) std::swap(triangles[i][0], triangles[i][2]);
    }
    const MeshHealth health = check({outward.vertices(), triangles});
    std::vector<std::pair<std::uint32_t, std::uint32_t>> wanted, found;
    for (const auto& [part, count] : counts) {
      if (is_turned[part]) wanted.emplace_back(part, count);
      cut_off_count += is_turned[part] && cut_off.contains(part);
    }
    for (const InsideOutPart& part : health.inside_out_parts) {
      found.emplace_back(part.triangle, part.triangle_count);
      inner += part.depth;
    }
    EXPECT_EQ(found, wanted) << n;
    turned_count += wanted.size();
  }
  EXPECT_GT(turned_count, 150u);
  EXPECT_GT(cut_off_count, 25u);
  EXPECT_GT(inner, 5u);
}

// What is behind and before a wall between two rooms is the same; nor is it said what faces out
// where a surface stays open.
TEST(InsideOutParts, WhatFacesNoSideIsNotJudged) {
  // Two rooms whose surfaces both have the wall between them.
  const Mesh room = tests::surface_of_cubes({{0, 0, 0}}).mesh();
  std::vector<Eigen::Vector3d> corners(room.vertices().begin(), room.vertices().end());
  std::vector<TriangleIndices> walls(room.triangles().begin(), room.triangles().end());
  for (const Eigen::Vector3d& corner : room.vertices())
    corners.push_back(corner + Eigen::Vector3d(1, 0, 0));
  for (const TriangleIndices& t : room.triangles())
    walls.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  EXPECT_TRUE(check({corners, walls}).inside_out_parts.empty());
  // A cube above a hole of a plate, all of it turned but its lower side.
  std::set<Cell> cells{{1, 1, 1}};
  for (int i = 0; i < 9; ++i)
    cells.insert({i % 3, i / 3, 0});
  cells.erase({1, 1, 0});
  const Mesh pile = tests::surface_of_cubes(cells).mesh();
  const auto height = [&](const TriangleIndices& t) {
    return std::accumulate(t.begin(), t.end(), 0.0, [&](double sum, std::uint32_t vertex) {
      return sum + pile.vertices()[vertex].z();
    });
  };
  std::vector<TriangleIndices> triangles(pile.triangles().begin(), pile.triangles().end());
  for (TriangleIndices& t : triangles) {
    if (height(t) > 3) std::swap(t[0], t[1]);
  }
  const MeshHealth turned = check({pile.vertices(), triangles});
  ASSERT_EQ(turned.inside_out_parts.size(), 1u);
  EXPECT_EQ(turned.inside_out_parts[0].triangle_count, 10u);
  triangles.erase(std::find_if(triangles.begin(), triangles.end(),
                               [&](const TriangleIndices& t) { return height(t) == 6; }));
  EXPECT_TRUE(check({pile.vertices(), triangles}).inside_out_parts.empty()) << "it is open";
}

}  // namespace
}  // namespace graze

// Open interiors of closed meshes, beside solids made of cells, of which it is known by numbers.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/pair.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/engine/solids/cell_solids.h"
#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using tests::block;
using tests::Cell;
using tests::CellSolid;
using tests::have_common_cell;
using tests::surface_of;

Pose moved(const Eigen::Vector3d& by) {
  Pose pose = Pose::Identity();
  pose.translation() = by;
  return pose;
}

/// What is said of both orders, which must be the same.
bool do_meet(const PlacedMeshView& a, const PlacedMeshView& b) {
  const bool is_met = interiors_intersect(a, b);
  EXPECT_EQ(interiors_intersect(b, a), is_met);
  return is_met;
}

TEST(Interiors, OfTwoBoxes) {
  const Mesh box = tests::make_box({1, 1, 1});
  const auto meet = [&](double x, double y, double z) {
    return do_meet(box, {box, moved({x, y, z})});
  };
  EXPECT_TRUE(meet(0, 0, 0)) << "equal solids";
  EXPECT_TRUE(meet(1, 0, 0)) << "four faces of each lie in those of the other";
  EXPECT_TRUE(meet(1, 1, 0));
  EXPECT_TRUE(meet(1, 1, 1));
  EXPECT_TRUE(meet(0x1p-40, 0, 0));
  EXPECT_TRUE(meet(2 - 0x1p-40, 0.5, 0.25));
  EXPECT_FALSE(meet(2, 0, 0)) << "walls that lie against each other";
  EXPECT_FALSE(meet(2, 1, 0)) << "that are shifted, too";
  EXPECT_FALSE(meet(2, 0.5, 0.25));
  EXPECT_FALSE(meet(2, 2, 0)) << "an edge";
  EXPECT_FALSE(meet(2, 2, 2)) << "a corner";
  EXPECT_FALSE(meet(2 + 0x1p-40, 0, 0));
  EXPECT_FALSE(meet(7, 0, 0));
  const Mesh small = tests::make_box({0.5, 0.5, 0.5});
  EXPECT_TRUE(do_meet(box, small)) << "wholly inside";
  EXPECT_TRUE(do_meet(box, {small, moved({0.5, 0, 0})})) << "inside, at a wall";
  EXPECT_TRUE(do_meet(box, {small, moved({0.5, 0.5, 0.5})})) << "inside, in a corner";
  EXPECT_FALSE(do_meet(box, {small, moved({1.5, 0, 0})})) << "outside, at the wall";
  EXPECT_FALSE(do_meet(box, {small, moved({1.5, 1.5, 0})}));
}

/// Each cell of [0, size)^3 with a chance of one in `chance`.
CellSolid random_solid(int size, int edge, int chance, RandomSource& source) {
  CellSolid solid{.edge = edge, .cells = {}};
  do {
    for (const Cell& cell : block({0, 0, 0}, {size, size, size}).cells) {
      if (source.integer(1, chance) == 1) solid.cells.insert(cell);
    }
  } while (solid.cells.empty());
  return solid;
}

TEST(Interiors, OfSolidsMadeOfCells) {
  RandomSource source(41);
  int met = 0, touching = 0;
  for (int n = 0; n < 250; ++n) {
    const int edge_a = n % 3 == 0 ? 2 : 1, edge_b = n % 5 == 0 ? 3 : 1;
    const CellSolid a = random_solid(edge_a == 1 ? 3 : 2, edge_a, 2 + n % 4, source);
    CellSolid b = random_solid(edge_b == 1 ? 3 : 1, edge_b, 1 + n % 5, source);
    if (n % 2 == 0) {  // only where the other is not: they touch at most
      std::erase_if(b.cells, [&](const Cell& cell) {
        return have_common_cell(a, {.edge = b.edge, .cells = {cell}});
      });
      if (b.cells.empty()) continue;
    }
    const Mesh mesh_a = surface_of(a, source), mesh_b = surface_of(b, source);
    const bool is_expected = have_common_cell(a, b);
    EXPECT_EQ(do_meet(mesh_a, mesh_b), is_expected) << n;
    met += is_expected;
    touching += !is_expected && intersects(mesh_a, mesh_b);
  }
  EXPECT_GT(met, 60);
  EXPECT_GT(touching, 60);
}

/// A box with its corners on the lattice, of 12 triangles however large it is.
Mesh large_box(const Cell& low, const Cell& high, RandomSource& source) {
  const Mesh unit = surface_of(block({0, 0, 0}, {1, 1, 1}), source);
  std::vector<Eigen::Vector3d> vertices;
  for (const Eigen::Vector3d& vertex : unit.vertices()) {
    Eigen::Vector3d moved;
    for (int k = 0; k < 3; ++k)
      moved[k] =
          vertex[k] == 0 ? low[static_cast<std::size_t>(k)] : high[static_cast<std::size_t>(k)];
    vertices.push_back(moved);
  }
  return {vertices, unit.triangles()};
}

TEST(Interiors, OfBoxesOnALattice) {
  RandomSource source(42);
  int met = 0, touching = 0;
  for (int n = 0; n < 800; ++n) {
    Cell low[2], high[2];
    bool is_expected = true;
    for (std::size_t k = 0; k < 3; ++k) {
      for (int i = 0; i < 2; ++i) {
        low[i][k] = static_cast<int>(source.integer(0, 4));
        high[i][k] = low[i][k] + static_cast<int>(source.integer(1, 4));
      }
      is_expected &= low[0][k] < high[1][k] && low[1][k] < high[0][k];
    }
    const Mesh a = large_box(low[0], high[0], source), b = large_box(low[1], high[1], source);
    EXPECT_EQ(do_meet(a, b), is_expected) << n;
    met += is_expected, touching += !is_expected && intersects(a, b);
  }
  EXPECT_GT(met, 150);
  EXPECT_GT(touching, 100);
}

// What fills a cavity touches all of its walls.
TEST(Interiors, OfACavityAndWhatFillsIt) {
  RandomSource source(43);
  CellSolid shell = block({0, 0, 0}, {3, 3, 3});
  shell.cells.erase({1, 1, 1});
  const Mesh hollow = surface_of(shell, source);
  EXPECT_FALSE(do_meet(hollow, surface_of(block({1, 1, 1}, {2, 2, 2}), source)));
  EXPECT_TRUE(do_meet(hollow, surface_of(block({1, 1, 1}, {2, 2, 3}), source)));
  EXPECT_TRUE(do_meet(hollow, surface_of(block({0, 0, 0}, {3, 3, 3}), source)));
  EXPECT_FALSE(do_meet(hollow, large_box({3, 0, 0}, {4, 3, 3}, source)));
  const Mesh seed = tests::make_box({0.25, 0.25, 0.25});
  EXPECT_FALSE(do_meet(hollow, {seed, moved({1.5, 1.5, 1.5})}))
      << "in the cavity, touching nothing";
  EXPECT_TRUE(do_meet(hollow, {seed, moved({0.5, 0.5, 0.5})}));
  EXPECT_FALSE(do_meet(hollow, {seed, moved({1.25, 1.5, 1.5})})) << "in the cavity, at its wall";
}

// Meshes that share triangles keep sharing them wherever they are placed, and what is on either
// side stays there.
TEST(Interiors, WallsThatAreTheSameTrianglesTouchInEveryPose) {
  RandomSource source(44);
  const Mesh box = tests::make_box({1, 1, 1});
  std::vector<Eigen::Vector3d> mirrored(box.vertices().begin(), box.vertices().end());
  for (Eigen::Vector3d& vertex : mirrored)
    vertex.x() = 2 - vertex.x();  // the wall at x = 1 stays
  const Mesh neighbour = box.deformed(mirrored);
  for (int n = 0; n < 40; ++n) {
    const Pose pose = tests::random_pose(n % 2 == 0 ? 1 : 1e6, source);
    EXPECT_FALSE(do_meet({box, pose}, {neighbour, pose})) << n;
    EXPECT_TRUE(do_meet({box, pose}, {box, pose})) << n;
  }
}

// A corner between the ends of a wall's edge, closed by a triangle without area.
TEST(Interiors, TrianglesWithoutAreaAreNothing) {
  const std::vector<Eigen::Vector3d> vertices{
      {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {2, 0, 0}};
  const std::vector<TriangleIndices> triangles{{0, 2, 4}, {4, 2, 1}, {0, 1, 3},
                                               {1, 2, 3}, {2, 0, 3}, {0, 4, 1}};
  const Mesh wedge(vertices, triangles);
  ASSERT_TRUE(wedge.topology().is_closed);
  const Mesh box = tests::make_box({1, 1, 1});
  EXPECT_TRUE(do_meet(wedge, wedge));
  EXPECT_TRUE(do_meet(wedge, box));
  EXPECT_FALSE(do_meet(wedge, {box, moved({1, 1, -1})})) << "below";
  EXPECT_FALSE(do_meet(wedge, {box, moved({2, -1, 1})})) << "beside the edge";
  EXPECT_FALSE(do_meet(wedge, {box, moved({2, -1, -1})})) << "along the edge";
  EXPECT_TRUE(do_meet(wedge, {box, moved({1, 1, 0.5})}));
}

template <typename Ask>
MeshError error_of(Ask&& ask) {
  try {
    ask();
  } catch (const MeshError& error) {
    return error;
  }
  return MeshError("nothing was thrown");
}

TEST(Law10Interiors, WhatIsNotClosedIsRefused) {
  const Mesh box = tests::make_box({1, 1, 1}), open = tests::make_row(1);
  const std::string boundary =
      " is not closed: it has 3 boundary edges, the first from vertex 0 to vertex 1 of triangle 0";
  EXPECT_EQ(error_of([&] { interiors_intersect(open, box); }).what(), "mesh A" + boundary);
  EXPECT_EQ(error_of([&] { interiors_intersect(box, open); }).what(), "mesh B" + boundary);
  Pose skewed = Pose::Identity();
  skewed.matrix()(0, 1) = 0.1;
  EXPECT_THROW(interiors_intersect(box, {box, skewed}), PoseError);
  EXPECT_THROW(interiors_intersect({box, skewed}, box), PoseError);
}

// Two boxes of one mesh that go through each other, where they touch a third.
TEST(Interiors, OfAMeshThatGoesThroughItself) {
  const Mesh box = tests::make_box({1, 1, 1});
  std::vector<Eigen::Vector3d> vertices(box.vertices().begin(), box.vertices().end());
  std::vector<TriangleIndices> triangles(box.triangles().begin(), box.triangles().end());
  for (const Eigen::Vector3d& vertex : box.vertices())
    vertices.push_back(vertex + Eigen::Vector3d(0, 0.5, 0.25));
  for (const TriangleIndices& t : box.triangles())
    triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  const Mesh crossed(vertices, triangles);
  EXPECT_FALSE(do_meet(crossed, {box, moved({2, 0, 0})}));
  EXPECT_TRUE(do_meet(crossed, {box, moved({1.75, 0, 0})}));
  EXPECT_FALSE(do_meet(crossed, {box, moved({9, 0, 0})}));
  EXPECT_FALSE(do_meet(crossed, {box, moved({-2, -2, 0})}));
  // By the even-odd rule nothing is where both are.
  const Mesh seed = tests::make_box({0.125, 0.125, 0.125});
  EXPECT_FALSE(do_meet(crossed, {seed, moved({0, 0.25, 0.125})}));
  EXPECT_TRUE(do_meet(crossed, {seed, moved({0, -0.75, 0})}));
  EXPECT_FALSE(do_meet(crossed, {seed, moved({0.875, 0.25, 0.125})})) << "at a wall of both";
  EXPECT_FALSE(do_meet(crossed, {seed, moved({1.125, 0.25, 0.125})})) << "and beyond it";
}

// A triangle that is there twice encloses nothing; what else there is in its part counts.
TEST(Interiors, SheetsAreNothing) {
  const std::vector<Eigen::Vector3d> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<TriangleIndices> sheet{{0, 1, 2}, {0, 1, 2}};
  const Mesh twice(corners, sheet), large = tests::make_box({9, 9, 9});
  EXPECT_FALSE(do_meet(twice, large));
  EXPECT_FALSE(do_meet({twice, moved({20, 0, 0})}, large));
  EXPECT_FALSE(do_meet(twice, twice));
  // A fin on a corner of a box, all within another; in each order of triangles.
  const Mesh box = tests::make_box({1, 1, 1});
  for (const bool is_fin_first : {false, true}) {
    std::vector<Eigen::Vector3d> vertices(box.vertices().begin(), box.vertices().end());
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), {{1, 1, 1}, {2, 1, 1}, {1, 2, 1}});
    std::vector<TriangleIndices> triangles(box.triangles().begin(), box.triangles().end());
    const std::vector<TriangleIndices> fin{{first, first + 1, first + 2},
                                           {first, first + 1, first + 2}};
    triangles.insert(is_fin_first ? triangles.begin() : triangles.end(), fin.begin(), fin.end());
    const Mesh finned(vertices, triangles);
    EXPECT_TRUE(do_meet(finned, large)) << is_fin_first;
    EXPECT_FALSE(do_meet(finned, {box, moved({2, 0, 0})})) << is_fin_first;
  }
}

TEST(Interiors, WorkIsCounted) {
  Work work;
  const Mesh box = tests::make_box({1, 1, 1});
  interiors_intersect(box, {box, moved({2, 0, 0})}, &work);
  EXPECT_GT(work.points_tested, 4u);
  EXPECT_GT(work.triangle_tests, 4u);
}

/// A slab of `strips` strips across a slanted plane, from one height above it to another.
Mesh slanted_slab(std::uint32_t strips, double from, double to) {
  std::vector<Eigen::Vector3d> vertices;
  for (std::uint32_t i = 0; i <= strips; ++i) {
    for (const double z : {from, to}) {
      for (const double x : {0.0, double(strips)})
        vertices.push_back({2 * x - 2 * i + z, 2 * x + i - 2 * z, x + 2 * i + 2 * z});
    }
  }
  std::vector<TriangleIndices> triangles;
  const auto side = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  };
  for (std::uint32_t i = 0; i < strips; ++i) {
    const std::uint32_t at = 4 * i, next = at + 4;
    side(at + 2, at + 3, next + 3, next + 2);
    side(at, next, next + 1, at + 1);
    side(at, at + 2, next + 2, next);
    side(at + 1, next + 1, next + 3, at + 3);
  }
  side(0, 1, 3, 2);
  side(4 * strips, 4 * strips + 2, 4 * strips + 3, 4 * strips + 1);
  return Mesh(vertices, triangles);
}

// Their axis-aligned boxes meet those of most others.
TEST(Interiors, LongSlantedTrianglesCostWhatIsNearThem) {
  const auto tests_of = [](std::uint32_t strips) {
    Work work;
    const Mesh lower = slanted_slab(strips, 0, 4), upper = slanted_slab(strips, 4, 8);
    EXPECT_FALSE(interiors_intersect(lower, upper, &work));
    EXPECT_TRUE(do_meet(lower, slanted_slab(strips, 3, 8)));
    return static_cast<double>(work.triangle_tests);
  };
  EXPECT_LT(tests_of(200) / tests_of(50), 6) << "four times as many";
}

}  // namespace
}  // namespace graze

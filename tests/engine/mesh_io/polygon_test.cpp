#include <graze/engine/mesh/io/polygon.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace graze::mesh_io {
namespace {

struct Grid {
  std::int64_t x;
  std::int64_t y;
};
using Outline = std::vector<Grid>;

std::int64_t doubled_area(Grid a, Grid b, Grid c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::int64_t doubled_area(const Outline& outline) {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    sum += doubled_area(outline[0], outline[i], outline[i + 1]);
  }
  return sum;
}

std::vector<TriangleIndices> cut(const std::vector<Eigen::Vector3d>& vertices) {
  std::vector<std::uint32_t> corners(vertices.size());
  std::iota(corners.begin(), corners.end(), 0u);
  std::vector<TriangleIndices> triangles(vertices.size() - 2);
  Triangulator().triangulate(vertices, corners, triangles);
  return triangles;
}

std::vector<TriangleIndices> cut(const Outline& outline) {
  std::vector<Eigen::Vector3d> vertices;
  for (const Grid p : outline)
    vertices.emplace_back(p.x, p.y, 0.0);
  return cut(vertices);
}

bool is_fan(const std::vector<TriangleIndices>& triangles) {
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (triangles[i] != TriangleIndices{0, i + 1, i + 2}) return false;
  }
  return true;
}

/// Every edge of the outline is in one triangle, every other edge in two, once each way: the
/// triangles are a triangulation of the corners.
void expect_triangulation(const std::vector<TriangleIndices>& triangles, std::size_t corners) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const TriangleIndices& t : triangles) {
    for (int k = 0; k < 3; ++k)
      edges.emplace_back(t[k], t[(k + 1) % 3]);
  }
  std::sort(edges.begin(), edges.end());
  ASSERT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end());
  for (const auto& [from, to] : edges) {
    const bool is_outline = to == (from + 1) % corners;
    const bool has_twin = std::binary_search(edges.begin(), edges.end(), std::pair(to, from));
    EXPECT_NE(is_outline, has_twin) << from << "-" << to;
  }
}

/// The law of the docstring: no triangle turns against the outline. Areas are whole numbers here,
/// so that the comparison is exact.
void expect_covers_inside(const Outline& outline) {
  const std::vector<TriangleIndices> triangles = cut(outline);
  expect_triangulation(triangles, outline.size());
  const std::int64_t whole = doubled_area(outline);
  std::int64_t sum = 0;
  for (const TriangleIndices& t : triangles) {
    sum += std::abs(doubled_area(outline[t[0]], outline[t[1]], outline[t[2]]));
  }
  EXPECT_EQ(sum, std::abs(whole));
}

/// Each rotation and both directions of the outline.
void expect_covers_inside_always(Outline outline) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    std::rotate(outline.begin(), outline.begin() + 1, outline.end());
    expect_covers_inside(outline);
    Outline reversed(outline.rbegin(), outline.rend());
    expect_covers_inside(reversed);
  }
}

TEST(Polygon, TrianglesStay) {
  EXPECT_EQ(cut(Outline{{0, 0}, {1, 0}, {0, 1}}), (std::vector<TriangleIndices>{{0, 1, 2}}));
}

TEST(Polygon, ConvexPolygonsAreFannedFromTheFirstCorner) {
  EXPECT_TRUE(is_fan(cut(Outline{{0, 0}, {2, 0}, {2, 2}, {0, 2}})));
  EXPECT_TRUE(is_fan(cut(Outline{{0, 2}, {2, 2}, {2, 0}, {0, 0}})));
  EXPECT_TRUE(is_fan(cut(Outline{{0, 0}, {4, 0}, {6, 3}, {4, 6}, {0, 6}, {-2, 3}})));
}

TEST(Polygon, ConcaveQuadsAreCutAtTheConcaveCorner) {
  const Outline dart = {{0, 0}, {4, 0}, {1, 1}, {0, 4}};
  expect_covers_inside_always(dart);
  // From its convex neighbours a fan would leave the dart: the cut must be from corner 0 to 2.
  const Outline rotated = {{4, 0}, {1, 1}, {0, 4}, {0, 0}};
  EXPECT_FALSE(is_fan(cut(rotated)));
}

TEST(Polygon, ConcavePolygonsKeepToTheirInside) {
  expect_covers_inside_always({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}});
  expect_covers_inside_always({{0, 0},
                               {7, 0},
                               {7, 6},
                               {2, 6},
                               {2, 2},
                               {5, 2},
                               {5, 4},
                               {4, 4},
                               {4, 3},
                               {3, 3},
                               {3, 5},
                               {6, 5},
                               {6, 1},
                               {1, 1},
                               {1, 7},
                               {0, 7}});
}

TEST(Polygon, FlatCornersGiveNoFlatTriangles) {
  const Outline outline = {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  expect_covers_inside_always(outline);
  for (const TriangleIndices& t : cut(outline)) {
    EXPECT_NE(doubled_area(outline[t[0]], outline[t[1]], outline[t[2]]), 0);
  }
}

TEST(Polygon, HolesJoinedByAnEdgeWalkedTwiceStayHoles) {
  expect_covers_inside_always(
      {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}});
  expect_covers_inside_always({{0, 0},
                               {12, 0},
                               {12, 9},
                               {0, 9},
                               {0, 0},
                               {2, 2},
                               {2, 4},
                               {4, 4},
                               {4, 2},
                               {2, 2},
                               {0, 0},
                               {6, 3},
                               {6, 5},
                               {8, 5},
                               {8, 3},
                               {6, 3}});
}

TEST(Polygon, RepeatedCornersAndSpikesKeepToTheirInside) {
  expect_covers_inside_always({{0, 0}, {4, 0}, {4, 0}, {1, 1}, {1, 1}, {1, 1}, {0, 4}});
  expect_covers_inside_always({{0, 0}, {4, 0}, {4, 4}, {6, 6}, {4, 4}, {3, 4}, {3, 1}, {0, 1}});
}

TEST(Polygon, WithoutAnInsideThereIsAFan) {
  EXPECT_TRUE(is_fan(cut(Outline{{0, 0}, {2, 2}, {2, 0}, {0, 2}})));
  EXPECT_TRUE(is_fan(cut(Outline{{0, 0}, {1, 1}, {3, 3}, {2, 2}, {5, 5}})));
  EXPECT_TRUE(is_fan(cut(Outline{{1, 1}, {1, 1}, {1, 1}, {1, 1}})));
}

TEST(Polygon, AnyPlaneAndAnyScaleWillDo) {
  const Outline dart = {{4, 0}, {1, 1}, {0, 4}, {0, 0}};
  const std::vector<TriangleIndices> expected = cut(dart);
  ASSERT_FALSE(is_fan(expected));
  for (const double scale : {5e-324, 1e-310, 1e-200, 1e-9, 1e9, 1e200, 4e307}) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<Eigen::Vector3d> vertices;
      for (const Grid p : dart) {
        Eigen::Vector3d& v = vertices.emplace_back();
        v[axis] = scale;
        v[(axis + 1) % 3] = static_cast<double>(p.x) * scale;
        v[(axis + 2) % 3] = static_cast<double>(p.y) * scale;
      }
      EXPECT_EQ(cut(vertices), expected) << scale << " " << axis;
    }
  }
}

TEST(Polygon, DifferencesMayOverflow) {
  constexpr double kHuge = 1.7e308;
  const std::vector<Eigen::Vector3d> dart = {
      {kHuge, -kHuge, 0}, {-kHuge / 2, -kHuge / 2, 0}, {-kHuge, kHuge, 0}, {-kHuge, -kHuge, 0}};
  EXPECT_FALSE(is_fan(cut(dart)));
}

/// A thin dart far from the origin: the rounded area has any sign, the exact turns decide.
TEST(Polygon, SliversAreDecidedExactly) {
  const double step = std::ldexp(1.0, -30);
  const std::vector<Eigen::Vector3d> dart = {{1 + 4 * step, 1 + 4 * step, 0},
                                             {1 + step, 1 + 2 * step, 0},
                                             {1, 1 + 4 * step, 0},
                                             {1, 1, 0}};
  const std::vector<TriangleIndices> triangles = cut(dart);
  ASSERT_EQ(triangles.size(), 2u);
  EXPECT_FALSE(is_fan(triangles));
}

/// A random simple polygon: corners around a centre in order of their direction.
Outline random_star(std::mt19937& random, int corners) {
  std::uniform_int_distribution<std::int64_t> coordinate(-20, 20);
  Outline outline;
  while (static_cast<int>(outline.size()) < corners) {
    const Grid p{coordinate(random), coordinate(random)};
    if (p.x != 0 || p.y != 0) outline.push_back(p);
  }
  const auto half = [](Grid p) { return p.y < 0 || (p.y == 0 && p.x < 0); };
  const auto is_before = [&](Grid a, Grid b) {
    if (half(a) != half(b)) return half(a) < half(b);
    const std::int64_t turn = a.x * b.y - a.y * b.x;
    return turn != 0 ? turn > 0 : a.x * a.x + a.y * a.y < b.x * b.x + b.y * b.y;
  };
  std::sort(outline.begin(), outline.end(), is_before);
  const auto is_same_direction = [&](Grid a, Grid b) {
    return !is_before(a, b) || a.x * b.y == a.y * b.x;
  };
  outline.erase(std::unique(outline.begin(), outline.end(), is_same_direction), outline.end());
  return outline;
}

/// True if no direction is left empty over half a turn or more: only then does the polygon wind
/// around the centre, and is it simple.
bool surrounds_centre(const Outline& outline) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (doubled_area({0, 0}, outline[i], outline[(i + 1) % outline.size()]) <= 0) return false;
  }
  return outline.size() >= 3;
}

TEST(Polygon, RandomSimplePolygonsKeepToTheirInside) {
  std::mt19937 random(1);
  int tested = 0;
  for (int i = 0; i < 5000; ++i) {
    const Outline outline = random_star(random, 4 + i % 30);
    if (!surrounds_centre(outline)) continue;
    expect_covers_inside(outline);
    ++tested;
  }
  EXPECT_GT(tested, 3000);
}

/// A random outline grown on a grid from one cell: each step adds a cell that touches what is there
/// along one edge, which is walked around instead.
Outline random_polyomino(std::mt19937& random, int steps) {
  Outline outline = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto has = [&](Grid p) {
    return std::ranges::any_of(outline, [&](Grid q) { return p.x == q.x && p.y == q.y; });
  };
  for (int i = 0; i < steps; ++i) {
    const std::size_t edge = random() % outline.size();
    const Grid a = outline[edge];
    const Grid b = outline[(edge + 1) % outline.size()];
    const Grid out{b.y - a.y, a.x - b.x};
    const Grid a_out{a.x + out.x, a.y + out.y};
    const Grid b_out{b.x + out.x, b.y + out.y};
    if (has(a_out) || has(b_out)) continue;
    const Grid added[] = {a_out, b_out};
    outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(edge) + 1, added, added + 2);
  }
  return outline;
}

TEST(Polygon, RandomPolyominoesKeepToTheirInside) {
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i)
    expect_covers_inside(random_polyomino(random, 2 + i % 60));
}

/// A hole joined to the outline where they are closest, so that the edge crosses nothing.
Outline with_hole(const Outline& outline, const Outline& hole) {
  std::size_t best_i = 0, best_j = 0;
  std::int64_t best = std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    for (std::size_t j = 0; j < hole.size(); ++j) {
      const std::int64_t x = outline[i].x - hole[j].x, y = outline[i].y - hole[j].y;
      if (x * x + y * y >= best) continue;
      best = x * x + y * y;
      best_i = i;
      best_j = j;
    }
  }
  Outline joined(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(best_i) + 1);
  for (std::size_t j = 0; j <= hole.size(); ++j) {
    joined.push_back(hole[(best_j + 2 * hole.size() - j) % hole.size()]);
  }
  joined.insert(joined.end(), outline.begin() + static_cast<std::ptrdiff_t>(best_i), outline.end());
  return joined;
}

TEST(Polygon, RandomHolesStayHoles) {
  std::mt19937 random(3);
  int tested = 0;
  for (int i = 0; i < 3000; ++i) {
    Outline outline = random_star(random, 4 + i % 20);
    const Outline hole = random_star(random, 3 + i % 11);
    if (!surrounds_centre(outline) || !surrounds_centre(hole)) continue;
    // Grown so far that no edge comes as close to the centre as the hole does: an edge between
    // whole coordinates up to 20 is at least 1 / 40 from the centre.
    for (Grid& p : outline)
      p = {p.x * 2000, p.y * 2000};
    expect_covers_inside(with_hole(outline, hole));
    ++tested;
  }
  EXPECT_GT(tested, 1000);
}

/// A comb of 8000 corners takes quadratic time, not cubic.
TEST(Polygon, LongOutlinesComeToAnEnd) {
  Outline comb;
  constexpr std::int64_t kTeeth = 2000;
  for (std::int64_t i = 0; i < kTeeth; ++i) {
    comb.insert(comb.end(), {{4 * i, 0}, {4 * i, 100}, {4 * i + 2, 100}, {4 * i + 2, 0}});
  }
  comb.push_back({4 * kTeeth, -1});
  comb.push_back({-1, -1});
  expect_covers_inside(comb);
}

}  // namespace
}  // namespace graze::mesh_io

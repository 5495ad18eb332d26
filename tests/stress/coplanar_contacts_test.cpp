// A box that rests on a box, both finely tessellated: thousands of coplanar contacts, counted again
// in the plane by whole numbers.

#include <graze/engine/mesh/pair.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace graze::stress {
namespace {

/// The surface of a box of `cells` cubic cells along each axis, two triangles to each face of a
/// cell. All coordinates are whole.
Mesh tessellated_box(const Eigen::Vector3d& low, int cells, int cell) {
  std::map<std::array<int, 3>, std::uint32_t> known;
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [entry, is_new] = known.emplace(at, static_cast<std::uint32_t>(vertices.size()));
    if (is_new) vertices.push_back(low + Eigen::Vector3d(at[0], at[1], at[2]) * cell);
    return entry->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const int level : {0, cells}) {
      for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
          const auto corner = [&](int u, int v) {
            std::array<int, 3> at{};
            at[axis] = level;
            at[(axis + 1) % 3] = i + u;
            at[(axis + 2) % 3] = j + v;
            return vertex(at);
          };
          const std::uint32_t p = corner(0, 0), q = corner(1, 0), r = corner(1, 1),
                              s = corner(0, 1);
          triangles.push_back({p, q, r});
          triangles.push_back({p, r, s});
        }
      }
    }
  }
  return Mesh(vertices, triangles);
}

using Point = std::array<std::int64_t, 2>;

/// The corners of each triangle that lie in the plane z = 0, which all triangles touch from one
/// side: what they have of the plane is the hull of these.
std::vector<std::vector<Point>> footprints(const Mesh& mesh) {
  std::vector<std::vector<Point>> all;
  for (const TriangleIndices& t : mesh.triangles()) {
    std::vector<Point> points;
    for (const std::uint32_t index : t) {
      const Eigen::Vector3d& p = mesh.vertices()[index];
      if (p.z() == 0) {
        points.push_back({static_cast<std::int64_t>(p.x()), static_cast<std::int64_t>(p.y())});
      }
    }
    if (!points.empty()) all.push_back(points);
  }
  return all;
}

bool is_gap(const std::vector<Point>& a, const std::vector<Point>& b, const Point& axis) {
  const auto range = [&](const std::vector<Point>& points) {
    std::int64_t low = INT64_MAX, high = INT64_MIN;
    for (const Point& p : points) {
      const std::int64_t x = p[0] * axis[0] + p[1] * axis[1];
      low = std::min(low, x);
      high = std::max(high, x);
    }
    return std::pair{low, high};
  };
  const auto [low_a, high_a] = range(a);
  const auto [low_b, high_b] = range(b);
  return high_a < low_b || high_b < low_a;
}

/// Closed hulls of one to three points: apart if and only if a gap shows along the axes of the
/// plane or across or along an edge of either.
bool do_meet(const std::vector<Point>& a, const std::vector<Point>& b) {
  if (is_gap(a, b, {1, 0}) || is_gap(a, b, {0, 1})) return false;
  for (const auto& points : {a, b}) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point& p = points[i];
      const Point& q = points[(i + 1) % points.size()];
      if (is_gap(a, b, {q[1] - p[1], p[0] - q[0]})) return false;
      if (is_gap(a, b, {q[0] - p[0], q[1] - p[1]})) return false;
    }
  }
  return true;
}

std::size_t count_in_plane(const Mesh& a, const Mesh& b) {
  const auto feet_a = footprints(a);
  const auto feet_b = footprints(b);
  std::size_t count = 0;
  for (const auto& foot_a : feet_a) {
    for (const auto& foot_b : feet_b)
      count += do_meet(foot_a, foot_b);
  }
  return count;
}

void check_resting(int cells_below, int cell_below, const Eigen::Vector3d& low, int cells_above,
                   int cell_above) {
  const Eigen::Vector3d ground(0, 0, -cells_below * cell_below);
  const Mesh below = tessellated_box(ground, cells_below, cell_below);
  const Mesh above = tessellated_box(low, cells_above, cell_above);
  const std::size_t expected = count_in_plane(below, above);
  EXPECT_GT(expected, 2000u);
  EXPECT_EQ(find_triangle_pairs({below}, {above}).size(), expected);
  EXPECT_EQ(find_triangle_pairs({above}, {below}, {.volume = PairVolume::Obb}).size(), expected);
  EXPECT_FALSE(intersects({below}, {above}, {.hit = Hit::Crossing})) << "nothing crosses";
  Pose lifted = Pose::Identity();
  lifted.translation().z() = 0x1p-1074;
  EXPECT_FALSE(intersects({below}, {above, lifted})) << "lifted by the smallest double";
}

TEST(StressContacts, ABoxRestingOnABox) {
  check_resting(30, 3, {10, 11, 0}, 14, 5);
}

TEST(StressContacts, BoxesOfOneSizeFaceOnFace) {
  check_resting(24, 4, {0, 0, 0}, 24, 4);
}

TEST(StressContacts, OverhangingByACorner) {
  check_resting(24, 3, {-20, -31, 0}, 18, 5);
}

TEST(StressContactsSlow, TensOfThousandsOfTriangles) {
  check_resting(120, 3, {17, 23, 0}, 60, 5);
}

}  // namespace
}  // namespace graze::stress

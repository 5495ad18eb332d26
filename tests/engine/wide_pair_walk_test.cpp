// Walks over two wide trees: where boxes, planes and triangles just touch nothing is pruned that
// meets.

#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_distance.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>
#include "tests/narrowphase/simd_targets.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <vector>

namespace graze {
namespace {

/// Two meshes of a few triangles, of which two touch to within rounding.
struct TouchingPair {
  Mesh a;
  Mesh b;
  Pose pose_a;
  Pose pose_b;
};

Mesh mesh_of(const std::vector<Eigen::Vector3d>& corners) {
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i + 2 < corners.size(); i += 3)
    triangles.push_back({i, i + 1, i + 2});
  return Mesh(corners, triangles);
}

/// A point of the triangle: in its inside, on an edge or a corner.
Eigen::Vector3d point_in(const Triangle& t, RandomSource& source) {
  double u = source.uniform(0, 1);
  double v = source.integer(0, 2) == 0 ? 0 : source.uniform(0, 1 - u);
  if (source.integer(0, 3) == 0) u = v = 0;
  return t.a + u * (t.b - t.a) + v * (t.c - t.a);
}

/// Corners within `size` of a point; flat and long now and then.
std::vector<Eigen::Vector3d> corners_near(const Eigen::Vector3d& p, double size, int count,
                                          RandomSource& source) {
  const double thin = source.integer(0, 2) == 0 ? 1e-6 : 1;
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 3 * count; ++i) {
    const Eigen::Vector3d offset = source.vector(-size, size);
    corners.push_back(p + Eigen::Vector3d(offset.x(), offset.y(), thin * offset.z()));
  }
  return corners;
}

TouchingPair touching_pair(RandomSource& source) {
  const double size_a = std::exp2(source.integer(-20, 20));
  const double size_b = size_a * std::exp2(source.integer(-20, 20));
  const double offset = source.integer(0, 1) * 1e3 * size_a;
  TouchingPair pair{mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
                    mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), tests::random_pose(offset, source),
                    tests::random_pose(offset, source)};
  const int count = static_cast<int>(source.integer(1, 6));
  pair.a = mesh_of(corners_near(source.vector(-offset, offset), size_a, count, source));
  const Triangle touched = place(pair.pose_a, pair.a.triangle(0));
  std::vector<Eigen::Vector3d> corners =
      corners_near(Eigen::Vector3d::Zero(), size_b, count, source);
  // The first corner of B comes to lie on A.
  const Eigen::Vector3d target = point_in(touched, source);
  pair.pose_b.translation() = target - pair.pose_b.linear() * corners[0];
  pair.b = mesh_of(corners);
  return pair;
}

// Law 9 where boxes, planes and triangles just touch, at all ratios of size: nothing that meets is
// pruned, and no distance is lost.
TEST(Law9WideTree, TrianglesThatJustTouch) {
  RandomSource source(503);
  int hits = 0;
  constexpr int kPairs = 4000;
  for (int n = 0; n < kPairs; ++n) {
    const TouchingPair pair = touching_pair(source);
    std::vector<TrianglePair> expected;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < pair.a.triangles().size(); ++i) {
      const Triangle s = place(pair.pose_a, pair.a.triangle(i));
      for (std::uint32_t j = 0; j < pair.b.triangles().size(); ++j) {
        const Triangle t = place(pair.pose_b, pair.b.triangle(j));
        if (intersects(s, t)) expected.push_back({i, j});
        least = std::min(least, distance(s, t).distance);
      }
    }
    const PlacedMesh a{pair.a, pair.pose_a};
    const PlacedMesh b{pair.b, pair.pose_b};
    ASSERT_EQ(find_triangle_pairs(a, b).pairs, expected) << n;
    ASSERT_EQ(find_triangle_pairs(b, a).size(), expected.size()) << n;
    ASSERT_EQ(intersects(a, b), !expected.empty()) << n;
    ASSERT_EQ(distance(a, b).distance, least) << n;
    hits += !expected.empty();
  }
  EXPECT_GT(hits, kPairs / 10);
  EXPECT_LT(hits, kPairs);
}

// From so far away that whole meshes are placed in a few points, and that the slack is more than a
// float can hold: then nothing may be pruned.
TEST(Law9WideTree, FromSoFarAwayThatNothingIsSure) {
  RandomSource source(505);
  for (const double offset : {1e14, 1e17, 1e30, 1e60, 1e200}) {
    const Mesh a = tests::random_soup({.count = 30}, source);
    const Mesh b = tests::random_soup({.count = 30}, source);
    Pose pose_a = tests::random_pose(0, source);
    Pose pose_b = tests::random_pose(0, source);
    pose_a.translation() << offset, -offset, 0.5 * offset;
    pose_b.translation() = pose_a.translation();
    std::vector<TrianglePair> expected;
    for (std::uint32_t i = 0; i < a.triangles().size(); ++i) {
      for (std::uint32_t j = 0; j < b.triangles().size(); ++j) {
        if (intersects(place(pose_a, a.triangle(i)), place(pose_b, b.triangle(j))))
          expected.push_back({i, j});
      }
    }
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(find_triangle_pairs({a, pose_a}, {b, pose_b}).pairs, expected) << offset;
    EXPECT_TRUE(intersects({a, pose_a}, {b, pose_b})) << offset;
    EXPECT_EQ(distance({a, pose_a}, {b, pose_b}).distance, 0) << offset;
  }
}

// A speck on a giant, up to ratios at which the giant overflows in the speck's units.
TEST(Law9WideTree, SpecksOnGiants) {
  RandomSource source(506);
  int hits = 0;
  for (int ratio = 40; ratio < 140; ++ratio) {
    for (int n = 0; n < 6; ++n) {
      const double giant = 0x1p64;
      const double speck = std::ldexp(giant, -ratio);
      const std::vector<Eigen::Vector3d> on =
          corners_near(Eigen::Vector3d::Zero(), speck, 6, source);
      std::vector<Eigen::Vector3d> wide = corners_near(Eigen::Vector3d::Zero(), giant, 6, source);
      wide[2] = -0.5 * wide[0] - 0.25 * wide[1];  // the first goes through the origin
      const Mesh a = mesh_of(wide);
      const Mesh b = mesh_of(on);
      std::vector<TrianglePair> expected;
      for (std::uint32_t i = 0; i < 6; ++i) {
        for (std::uint32_t j = 0; j < 6; ++j) {
          if (intersects(a.triangle(i), b.triangle(j))) expected.push_back({i, j});
        }
      }
      ASSERT_EQ(find_triangle_pairs({a}, {b}).pairs, expected) << ratio;
      ASSERT_EQ(find_triangle_pairs({b}, {a}).size(), expected.size()) << ratio;
      ASSERT_EQ(distance({a}, {b}).distance == 0, !expected.empty()) << ratio;
      hits += !expected.empty();
    }
  }
  EXPECT_GT(hits, 50);
}

/// The twelve edges of a box as triangles that are flat to the last: nothing but the axes that
/// stand on two edges proves such frames apart.
Mesh frame_of_bars(const Eigen::Vector3d& half) {
  std::vector<Eigen::Vector3d> corners;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 4; ++side) {
      Eigen::Vector3d end = half;
      end[(axis + 1) % 3] *= side & 1 ? 1 : -1;
      end[(axis + 2) % 3] *= side & 2 ? 1 : -1;
      Eigen::Vector3d begin = end;
      begin[axis] = -half[axis];
      corners.insert(corners.end(), {begin, end, 0.5 * (begin + end)});
    }
  }
  return mesh_of(corners);
}

Eigen::Vector3d random_half(RandomSource& source) {
  const double x = std::exp2(source.integer(-5, 5));
  const double y = std::exp2(source.integer(-5, 5));
  return {x, y, std::exp2(source.integer(-5, 5))};
}

/// A point of that edge along an axis of a box that lies farthest in a direction at right angles.
Eigen::Vector3d edge_point(const Eigen::Vector3d& half, int axis, const Eigen::Vector3d& direction,
                           RandomSource& source) {
  Eigen::Vector3d point;
  for (int k = 0; k < 3; ++k)
    point[k] = k == axis ? source.uniform(-1, 1) * half[k] : direction[k] < 0 ? -half[k] : half[k];
  return point;
}

// Edges that cross in one point: what the fifteen axes make of boxes must hold along each of them.
TEST(Law9WideTree, EdgesThatJustCross) {
  RandomSource source(504);
  int hits = 0;
  constexpr int kPairs = 3000;
  for (int n = 0; n < kPairs; ++n) {
    const Eigen::Vector3d half_a = random_half(source);
    const Eigen::Vector3d half_b = random_half(source);
    const Mesh a = frame_of_bars(half_a);
    const Mesh b = frame_of_bars(half_b);
    Pose pose = tests::random_pose(0, source);
    // Of the edges along one axis of each, those that face each other along their common normal are
    // brought together: the boxes touch there, and nowhere else.
    const auto axis_a = static_cast<int>(source.integer(0, 2));
    const auto axis_b = static_cast<int>(source.integer(0, 2));
    const Eigen::Vector3d normal = Eigen::Vector3d::Unit(axis_a).cross(pose.linear().col(axis_b));
    const Eigen::Vector3d on_a = edge_point(half_a, axis_a, normal, source);
    const Eigen::Vector3d on_b =
        edge_point(half_b, axis_b, -(pose.linear().transpose() * normal), source);
    pose.translation() = on_a - pose.linear() * on_b;
    std::vector<TrianglePair> expected;
    for (std::uint32_t i = 0; i < a.triangles().size(); ++i) {
      for (std::uint32_t j = 0; j < b.triangles().size(); ++j) {
        if (intersects(a.triangle(i), place(pose, b.triangle(j)))) expected.push_back({i, j});
      }
    }
    // Edges of doubles hardly ever meet: a hair's breadth decides, which trees must leave open.
    Work work;
    ASSERT_EQ(find_triangle_pairs({a}, {b, pose}, {}, &work).pairs, expected) << n;
    hits += work.triangle_tests > 0;
  }
  EXPECT_EQ(hits, kPairs);
}

// Law 8: which pairs a limited query finds, too.
TEST(Law8WideTree, EverySimdTargetFindsTheSame) {
  RandomSource source(502);
  const Mesh sphere = tests::make_sphere(1, 50, 50);
  const Mesh soup = tests::random_soup({.count = 400, .extent = 1.2, .size = 0.2}, source);
  std::vector<Pose> poses;
  for (int n = 0; n < 10; ++n)
    poses.push_back(tests::random_pose(0.5, source));
  std::vector<std::vector<TrianglePair>> first;
  std::vector<double> first_gaps;
  for (const std::int64_t target : narrowphase::simd_targets()) {
    narrowphase::force_simd_target(target);
    std::vector<std::vector<TrianglePair>> found;
    std::vector<double> gaps;
    for (const Pose& pose : poses) {
      found.push_back(find_triangle_pairs({sphere}, {soup, pose}, {.limit = 7}).pairs);
      found.push_back(find_triangle_pairs({sphere}, {soup, pose}).pairs);
      Pose apart = pose;
      apart.translation().x() += 4;
      const MeshDistance gap = distance({sphere}, {soup, apart});
      gaps.insert(gaps.end(), {gap.distance, gap.point_a.x(), gap.point_b.z()});
    }
    if (first.empty()) {
      first = found;
      first_gaps = gaps;
    }
    EXPECT_EQ(found, first);
    EXPECT_EQ(gaps, first_gaps);
  }
  narrowphase::force_simd_target(0);
  ASSERT_FALSE(first.empty());
  EXPECT_EQ(first[0].size(), 7u);
}

}  // namespace
}  // namespace graze

#include <graze/bvh/wide/tree/wide_tree.h>
#include <graze/engine/mesh/data/mesh_trees.h>
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

using bvh::ChildLink;
using bvh::WideNode;
using bvh::WideTree;

/// A corner in the tree's frame.
Eigen::Vector3d local(const Eigen::Vector3d& p, const WideTree& tree) {
  const double* c = tree.frame().centre;
  return (p - Eigen::Vector3d(c[0], c[1], c[2])) * std::ldexp(1.0, -tree.frame().exponent);
}

/// Both the box and the slab.
bool holds(const WideNode& node, std::uint32_t lane, const Eigen::Vector3d& p) {
  const double slope[3] = {WideNode::slope_of(node.slope[0][lane]),
                           WideNode::slope_of(node.slope[1][lane]), 1};
  double from_middle = 0;
  double reach = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double along = 0;
    for (int k = 0; k < 3; ++k)
      along += double{node.axes[k][axis]} * (p[k] - node.origin[k]);
    along -= node.centre[axis][lane];
    if (std::abs(along) > node.half[axis][lane]) return false;
    from_middle += slope[axis] * along;
    reach += std::abs(slope[axis]) * node.half[axis][lane];
  }
  from_middle -= node.slab_middle[lane] * reach / 128;
  return std::abs(from_middle) <= (node.slab_half[lane] + 1) * reach / 256;
}

/// The places of all primitives below a lane; checks that its box holds their corners.
std::vector<std::uint32_t> checked_places(const Mesh& mesh, const WideTree& tree,
                                          std::uint32_t treelet, const WideNode& node,
                                          std::uint32_t lane) {
  const std::uint32_t link = node.child[lane];
  std::vector<std::uint32_t> places;
  if (ChildLink::is_leaf(link)) {
    for (std::uint32_t i = 0; i < ChildLink::count(link); ++i)
      places.push_back(tree.treelet(treelet).first + ChildLink::first(link) + i);
  } else {
    const bool is_entering = ChildLink::is_treelet(link);
    const std::uint32_t index = ChildLink::index(link);
    const std::uint32_t below = is_entering ? index : treelet;
    const WideNode& child = is_entering ? tree.treelet(index).nodes[0] : (&node)[index];
    for (std::uint32_t j = 0; j < child.count; ++j) {
      const auto some = checked_places(mesh, tree, below, child, j);
      places.insert(places.end(), some.begin(), some.end());
    }
  }
  for (const std::uint32_t place : places) {
    const Triangle triangle = mesh.triangle(tree.primitive(place));
    for (const Eigen::Vector3d& p : {triangle.a, triangle.b, triangle.c})
      EXPECT_TRUE(holds(node, lane, local(p, tree)));
  }
  return places;
}

void expect_sound(const Mesh& mesh) {
  const WideTree& tree = wide_tree_of(mesh);
  tree.build_all();
  std::vector<std::uint32_t> places =
      checked_places(mesh, tree, 0, *tree.root().node, tree.root().lane);
  std::sort(places.begin(), places.end());
  ASSERT_EQ(places.size(), mesh.triangles().size());
  std::vector<bool> is_seen(places.size());
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    ASSERT_EQ(places[i], i);
    is_seen[tree.primitive(i)] = true;
  }
  EXPECT_EQ(std::count(is_seen.begin(), is_seen.end(), true), std::ssize(is_seen));
}

TEST(Law5WideTree, BoxesHoldAllCornersBelowThem) {
  RandomSource source(501);
  expect_sound(tests::make_sphere(1, 80, 80));
  expect_sound(tests::make_torus(1, 0.01, 100, 40));
  for (const double scale : {1e-310, 1e-160, 1.0, 1e150, 1e300}) {
    expect_sound(tests::random_soup({.count = 1, .extent = scale, .size = scale}, source));
    expect_sound(tests::random_soup({.count = 300, .extent = scale, .size = 0.1 * scale}, source));
  }
  for (const double offset : {1e6, 1e15})
    expect_sound(tests::random_soup(
        {.count = 200, .centre = Eigen::Vector3d(1, -0.7, 0.3) * offset}, source));
}

/// Refitted, in all or in part, or built anew: in the end after a chain of moves.
TEST(Law5WideTree, BoxesOfDeformedMeshesHoldAllCornersBelowThem) {
  RandomSource source(507);
  for (const double size : {1e-3, 0.05, 0.5}) {
    Mesh mesh = tests::make_torus(1, 0.3, 80, 40);
    for (int n = 0; n < 3; ++n) {
      wide_tree_of(mesh).build_all();
      std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
      const double scale = std::exp2(source.integer(-300, 300));
      for (Eigen::Vector3d& p : vertices) {
        if (p.z() < 0) p += size * source.vector(-1, 1);
        p = p * scale + Eigen::Vector3d(1000 * scale, 0, 0);
      }
      const Mesh moved = mesh.deformed(vertices);
      expect_sound(moved);
      for (Eigen::Vector3d& p : vertices)
        p = p / scale - Eigen::Vector3d(1000, 0, 0);
      mesh = moved.deformed(vertices);
      expect_sound(mesh);
    }
  }
}

/// All nodes and corners, treelet by treelet.
std::vector<unsigned char> bytes_of(const WideTree& tree) {
  std::vector<unsigned char> bytes;
  const auto append = [&](const auto& values) {
    const auto* first = reinterpret_cast<const unsigned char*>(values.data());
    bytes.insert(bytes.end(), first, first + values.size() * sizeof(values[0]));
  };
  for (std::uint32_t i = 0; i < tree.treelet_count(); ++i) {
    append(tree.treelet(i).nodes);
    append(tree.treelet(i).corners);
  }
  return bytes;
}

TEST(WideTree, IsTheSameInWhateverOrderItIsBuilt) {
  const Mesh one = tests::make_sphere(1, 120, 120);
  const Mesh other(one.vertices(), one.triangles());
  wide_tree_of(one).build_all();
  const WideTree& tree = wide_tree_of(other);
  ASSERT_GT(tree.treelet_count(), 5u);
  bvh::TreeletCounts counts;
  for (auto i = static_cast<std::uint32_t>(tree.treelet_count()); i-- > 1;)
    tree.entered(i, counts);
  EXPECT_EQ(counts.built, tree.treelet_count() - 1);
  EXPECT_EQ(tree.build_all().built, 0u);
  EXPECT_EQ(bytes_of(wide_tree_of(one)), bytes_of(tree));
}

TEST(WideTree, IsTheSameInWhateverOrderItIsRefitted) {
  RandomSource source(508);
  const Mesh mesh = tests::random_soup({.count = 12000, .size = 0.02}, source);
  wide_tree_of(mesh).build_all();
  // On one side triangles trade places, on the other they tremble.
  std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    vertices[i] += 1e-4 * source.vector(-1, 1);
    const std::size_t triangle = i / 3;
    if (mesh.vertices()[3 * triangle].x() > 0.6 && triangle % 2 == 1) vertices[i].z() *= -1;
  }
  const Mesh one = mesh.deformed(vertices);
  const Mesh other = mesh.deformed(vertices);
  const bvh::TreeletCounts all = wide_tree_of(one).build_all();
  bvh::TreeletCounts counts;
  for (auto i = static_cast<std::uint32_t>(wide_tree_of(other).treelet_count()); i-- > 1;)
    wide_tree_of(other).entered(i, counts);
  EXPECT_EQ(counts.built, all.built);
  EXPECT_EQ(counts.refitted, all.refitted);
  EXPECT_GT(counts.built, 0u);
  EXPECT_GT(counts.refitted, 0u);
  EXPECT_EQ(bytes_of(wide_tree_of(one)), bytes_of(wide_tree_of(other)));
}

TEST(WideTree, OnlyWhatIsWalkedIsBuilt) {
  const Mesh a = tests::make_sphere(1, 200, 200);
  const Mesh b(a.vertices(), a.triangles());
  const auto built_at = [&](double distance) {
    Work work;
    Pose pose = Pose::Identity();
    pose.translation() << 0.6 * distance, 0.8 * distance, 0;
    intersects({a}, {b, pose}, &work);
    return work.treelets_built;
  };
  EXPECT_EQ(built_at(10), 0u);
  const std::uint64_t near = built_at(2.001);
  EXPECT_GT(near, 0u);
  EXPECT_LT(near, 20u);
  EXPECT_EQ(built_at(2.001), 0u);
  EXPECT_GT(wide_tree_of(a).treelet_count(), 30u);
}

TEST(WideTree, TakesAtMostSixtyBytesATriangle) {
  const Mesh mesh = tests::make_sphere(1, 200, 200);
  const WideTree& tree = wide_tree_of(mesh);
  tree.build_all();
  EXPECT_LE(static_cast<double>(tree.bytes()), 60.0 * static_cast<double>(mesh.triangles().size()));
}

// Planes and boxes of leaves are tried in float before anything is placed.
TEST(WideTree, LeavesLetLittleThroughThatDoesNotMeet) {
  const Mesh sphere = tests::make_sphere(1, 100, 100);
  Pose pose = Pose::Identity();
  pose.translation() << 0.7, 0.4, 0.3;
  Work work;
  const std::size_t pairs = find_triangle_pairs({sphere}, {sphere, pose}, {}, &work).size();
  EXPECT_GT(pairs, 100u);
  EXPECT_LT(work.triangle_tests, 3 * pairs);
  EXPECT_GT(work.filter_tests, 3 * work.triangle_tests);
}

/// Hills and valleys over a square, with a grid of so many squares a side.
Mesh make_hills(int side) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (int i = 0; i <= side; ++i) {
    for (int j = 0; j <= side; ++j) {
      const double x = static_cast<double>(i) / side;
      const double y = static_cast<double>(j) / side;
      vertices.emplace_back(x, y, 0.05 * std::sin(6 * x) * std::cos(7 * y));
      if (i == side || j == side) continue;
      const auto at = static_cast<std::uint32_t>(i * (side + 1) + j);
      const auto next = at + static_cast<std::uint32_t>(side + 1);
      triangles.push_back({at, at + 1, next});
      triangles.push_back({at + 1, next + 1, next});
    }
  }
  return Mesh(vertices, triangles);
}

// A thousandth of their size apart: boxes along axes that eight children share are too thick for
// that down to the leaves; slabs are not.
TEST(WideTree, SlabsKeepNearlyParallelSheetsApart) {
  const Mesh hills = make_hills(100);
  Pose above = Pose::Identity();
  above.translation().z() = 0.0015;
  Work work;
  EXPECT_FALSE(intersects({hills}, {hills, above}, &work));
  EXPECT_EQ(work.filter_tests, 0u);
  EXPECT_LT(work.volume_tests, 10 * hills.triangles().size());
  above.translation().z() = 0;
  EXPECT_TRUE(intersects({hills}, {hills, above}));
}

// A leaf of large triangles has a box that is mostly empty beside small ones.
TEST(WideTree, LargeTrianglesMeetFewSmallOnes) {
  const Mesh hills = make_hills(8);
  const Mesh ball = tests::make_sphere(0.2, 60, 60);
  Pose above = Pose::Identity();
  above.translation() << 0.5, 0.5, 0.23;
  Work work;
  EXPECT_FALSE(intersects({hills}, {ball, above}, &work));
  EXPECT_LT(work.volume_tests, 300u);
  EXPECT_LT(work.filter_tests, 100u);
  above.translation().z() = 0.15;
  EXPECT_TRUE(intersects({hills}, {ball, above}));
}

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
    const Eigen::Vector3d way = source.vector(-size, size);
    corners.push_back(p + Eigen::Vector3d(way.x(), way.y(), thin * way.z()));
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

#include <graze/bvh/wide/tree/wide_tree.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <gtest/gtest.h>
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
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
  const std::uint64_t near = built_at(2.000002);
  EXPECT_GT(near, 0u);
  EXPECT_LT(near, 20u);
  EXPECT_EQ(built_at(2.000002), 0u);
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

}  // namespace
}  // namespace graze

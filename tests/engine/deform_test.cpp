#include <graze/bvh/tree/tree.h>
#include <graze/bvh/tree/validate.h>
#include <graze/bvh/wide/tree/wide_tree.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/prepare.h>
#include <graze/narrowphase/triangle_distance.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace graze {
namespace {

using Vertices = std::vector<Eigen::Vector3d>;

Vertices vertices_of(const Mesh& mesh) {
  return {mesh.vertices().begin(), mesh.vertices().end()};
}

/// The same triangles in the same places, of which nothing has been built.
Mesh fresh(const Mesh& mesh) {
  return Mesh(mesh.vertices(), mesh.triangles());
}

Vertices with_noise(Vertices vertices, double size, RandomSource& source) {
  for (Eigen::Vector3d& p : vertices)
    p += source.vector(-size, size);
  return vertices;
}

/// Turned about the z axis, by so much from z = -1 to z = 1, in steps that need no sine.
Vertices twisted(Vertices vertices, int eighths) {
  const Eigen::Matrix2d eighth{{std::sqrt(0.5), -std::sqrt(0.5)}, {std::sqrt(0.5), std::sqrt(0.5)}};
  for (Eigen::Vector3d& p : vertices) {
    const double turn = 0.5 * (p.z() + 1) * eighths;
    const double whole = std::floor(turn);
    Eigen::Vector2d q = p.head<2>();
    for (int i = 0; i < static_cast<int>(whole); ++i)
      q = eighth * q;
    p.head<2>() = (1 - (turn - whole)) * q + (turn - whole) * (eighth * q);
  }
  return vertices;
}

Vertices shuffled(Vertices vertices, RandomSource& source) {
  for (std::size_t i = vertices.size(); i-- > 1;)
    std::swap(vertices[i],
              vertices[static_cast<std::size_t>(source.integer(0, static_cast<int>(i)))]);
  return vertices;
}

void expect_brute_force(const PlacedMesh& a, const PlacedMesh& b, const std::string& what) {
  std::vector<TrianglePair> expected;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < a.mesh.triangles().size(); ++i) {
    const Triangle s = place(a.pose, a.mesh.triangle(i));
    for (std::uint32_t j = 0; j < b.mesh.triangles().size(); ++j) {
      const Triangle t = place(b.pose, b.mesh.triangle(j));
      if (intersects(s, t)) expected.push_back({i, j});
      least = std::min(least, distance(s, t).distance);
    }
  }
  EXPECT_EQ(find_triangle_pairs(a, b).pairs, expected) << what;
  EXPECT_EQ(find_triangle_pairs(a, b, {.volume = PairVolume::Aabb}).pairs, expected) << what;
  EXPECT_EQ(find_triangle_pairs(a, b, {.volume = PairVolume::Obb}).pairs, expected) << what;
  EXPECT_EQ(intersects(a, b), !expected.empty()) << what;
  EXPECT_EQ(distance(a, b).distance, least) << what;
}

void expect_valid_binary_tree(const Mesh& mesh) {
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const Triangle t = mesh.triangle(i);
    boxes.push_back({t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)});
  }
  EXPECT_EQ(bvh::find_broken_invariant(tree_of(mesh), boxes).value_or(""), "");
}

/// One of many ways to move vertices, some of which leave nothing of the mesh's shape.
Vertices deformed_somehow(const Vertices& vertices, RandomSource& source) {
  Vertices moved = vertices;
  switch (static_cast<int>(source.integer(0, 6))) {
    case 0:
      return with_noise(vertices, 1e-3, source);
    case 1:
      return with_noise(vertices, 1, source);
    case 2:
      return twisted(vertices, 8);
    case 3:
      return shuffled(vertices, source);
    case 4:  // flat, or a line
      for (Eigen::Vector3d& p : moved)
        p.tail(static_cast<Eigen::Index>(source.integer(0, 1)) + 1).setZero();
      return moved;
    case 5:  // all in one point
      for (Eigen::Vector3d& p : moved)
        p = vertices[0];
      return moved;
    default:
      return vertices;
  }
}

// Law 9: along a chain of deformations, of which some are asked and others passed over.
TEST(Law9Deform, AnyDeformationAnswersAsBruteForce) {
  RandomSource source(901);
  for (int chain = 0; chain < 12; ++chain) {
    Mesh a = tests::random_soup({.count = 50}, source);
    const Vertices start = vertices_of(a);
    const Mesh b = tests::random_soup({.count = 40}, source);
    for (int n = 0; n < 8; ++n) {
      a = a.deformed(deformed_somehow(start, source));
      if (source.integer(0, 3) == 0) continue;
      const Pose pose = tests::random_pose(0.5, source);
      expect_brute_force({a}, {b, pose}, std::to_string(chain) + "/" + std::to_string(n));
      expect_valid_binary_tree(a);
    }
  }
}

TEST(Law9Deform, ExtremeScales) {
  RandomSource source(902);
  for (const double scale : {1e-310, 1e-160, 1e-20, 1e20, 1e100}) {
    for (const double offset : {0.0, 1e3}) {
      Mesh a = tests::random_soup({.count = 40}, source);
      Mesh b = tests::random_soup({.count = 40}, source);
      EXPECT_TRUE(intersects({a}, {b}));
      const auto moved = [&](const Mesh& mesh) {
        Vertices vertices = vertices_of(mesh);
        for (Eigen::Vector3d& p : vertices)
          p = (p + Eigen::Vector3d(offset, -offset, 0)) * scale;
        return mesh.deformed(vertices);
      };
      a = moved(a);
      b = moved(b);
      expect_brute_force({a}, {b}, std::to_string(scale) + "+" + std::to_string(offset));
    }
  }
}

// Thousands of triangles: many treelets, kept and built anew.
TEST(Law9Deform, LargeMeshesAnswerAsFreshOnes) {
  RandomSource source(903);
  const Mesh sphere = tests::make_sphere(1, 90, 90);
  const Mesh other = tests::make_torus(0.8, 0.3, 40, 20);
  prepare(sphere);
  tree_of(sphere);
  for (const Vertices& vertices :
       {with_noise(vertices_of(sphere), 0.003, source),
        with_noise(vertices_of(sphere), 0.2, source), twisted(vertices_of(sphere), 8),
        shuffled(vertices_of(sphere), source)}) {
    const Mesh moved = sphere.deformed(vertices);
    const Mesh anew = fresh(moved);
    const Pose pose = tests::random_pose(0.2, source);
    for (const PairVolume volume : {PairVolume::WideObb, PairVolume::Aabb}) {
      const TrianglePairs pairs = find_triangle_pairs({moved}, {other, pose}, {.volume = volume});
      EXPECT_EQ(pairs.pairs, find_triangle_pairs({anew}, {other, pose}).pairs);
      EXPECT_FALSE(pairs.empty());
    }
    Pose apart = pose;
    apart.translation().z() += 4;
    EXPECT_EQ(distance({moved}, {other, apart}).distance,
              distance({anew}, {other, apart}).distance);
  }
}

Work prepared(const Mesh& mesh) {
  Work work;
  prepare(mesh, {}, &work);
  tree_of(mesh, &work);
  return work;
}

TEST(Deform, WhatFitsIsRefittedAndNotBuilt) {
  RandomSource source(904);
  const Mesh mesh = tests::make_sphere(1, 120, 120);
  const std::uint64_t treelets = prepared(mesh).treelets_built;
  ASSERT_GT(treelets, 8u);
  const Mesh moved = mesh.deformed(with_noise(vertices_of(mesh), 0.002, source));
  Work work = prepared(moved);
  EXPECT_EQ(work.trees_refitted, 2u);
  EXPECT_EQ(work.trees_built, 0u);
  EXPECT_EQ(work.treelets_refitted, treelets);
  EXPECT_EQ(work.treelets_built, 0u);
  EXPECT_EQ(work.triangles_rebuilt, 0u);
  work = prepared(moved);
  EXPECT_EQ(work.trees_refitted + work.treelets_refitted, 0u);
}

TEST(Deform, WhatHasDegradedIsBuiltAnewWhereItIs) {
  RandomSource source(905);
  const Mesh mesh = tests::random_soup({.count = 20000, .size = 0.02}, source);
  const std::uint64_t treelets = prepared(mesh).treelets_built;
  // Triangles in a corner of the cube trade places.
  Vertices vertices = vertices_of(mesh);
  std::vector<TriangleIndices> corner;
  for (const TriangleIndices& t : mesh.triangles()) {
    if (vertices[t[0]].maxCoeff() < 0) corner.push_back(t);
  }
  for (std::size_t i = 0; i < corner.size() / 2; ++i) {
    for (int k = 0; k < 3; ++k)
      std::swap(vertices[corner[i][k]], vertices[corner[corner.size() - 1 - i][k]]);
  }
  const Mesh scrambled = mesh.deformed(vertices);
  const Work work = prepared(scrambled);
  EXPECT_GT(work.treelets_built, 0u);
  EXPECT_LT(work.treelets_built, treelets / 2);
  EXPECT_GT(work.treelets_refitted, treelets / 2);
  EXPECT_GT(work.triangles_rebuilt, corner.size() / 4);
  EXPECT_LT(work.triangles_rebuilt, mesh.triangles().size() * 2 / 3);
  // All of them do.
  vertices = vertices_of(mesh);
  std::reverse(vertices.begin(), vertices.end());
  const Work all = prepared(mesh.deformed(vertices));
  EXPECT_EQ(all.treelets_refitted, 0u);
  EXPECT_GE(all.treelets_built, treelets / 2);
  EXPECT_EQ(all.triangles_rebuilt, mesh.triangles().size());
  expect_valid_binary_tree(scrambled);
}

// A tree that is asked little refits little, and what no query of a mesh needed waits for later
// ones, over meshes that nobody asks at all.
TEST(Deform, OnlyWhatIsWalkedIsRefitted) {
  RandomSource source(906);
  const Mesh mesh = tests::make_sphere(1, 150, 150);
  const std::uint64_t treelets = prepared(mesh).treelets_built;
  const Mesh probe = tests::make_box({0.01, 0.01, 0.01});
  Pose at_pole = Pose::Identity();
  at_pole.translation().z() = 1;
  Mesh moved = mesh;
  for (int n = 0; n < 3; ++n)
    moved = moved.deformed(with_noise(vertices_of(mesh), 1e-4, source));
  Work work;
  EXPECT_TRUE(intersects({moved}, {probe, at_pole}, &work));
  EXPECT_EQ(work.trees_refitted, 1u);
  EXPECT_GT(work.treelets_refitted, 0u);
  EXPECT_LT(work.treelets_refitted, treelets / 3);
  EXPECT_LE(work.treelets_built, 1u);  // the probe's
  work = prepared(moved.deformed(with_noise(vertices_of(mesh), 1e-4, source)));
  EXPECT_EQ(work.treelets_refitted, treelets);
  EXPECT_EQ(work.treelets_built, 0u);
}

TEST(Deform, WhatWasNeverBuiltIsBuilt) {
  const Mesh mesh = tests::make_sphere(1, 60, 60);
  const Work work = prepared(mesh.deformed(mesh.vertices()));
  EXPECT_EQ(work.trees_built, 2u);
  EXPECT_EQ(work.trees_refitted, 0u);
}

/// Pairs of boxes that a walk compares.
std::uint64_t tests_of(const Mesh& mesh, const Mesh& other, PairVolume volume) {
  Work work;
  for (const double z : {-0.4, 0.0, 0.5}) {
    Pose pose = Pose::Identity();
    pose.translation() << 0.3, -0.2, z;
    find_triangle_pairs({mesh}, {other, pose}, {.volume = volume}, &work);
  }
  return work.volume_tests + work.filter_tests;
}

// However far a deformation goes, trees are as good as new.
TEST(Deform, QueriesCostAboutWhatTheyDoOnFreshTrees) {
  RandomSource source(907);
  const Mesh sphere = tests::make_sphere(1, 70, 70);
  prepared(sphere);
  for (const Vertices& vertices :
       {with_noise(vertices_of(sphere), 0.005, source),
        with_noise(vertices_of(sphere), 0.1, source), twisted(vertices_of(sphere), 8),
        shuffled(vertices_of(sphere), source)}) {
    Mesh moved = sphere;
    for (int step = 1; step <= 4; ++step) {
      Vertices between = vertices_of(sphere);
      for (std::size_t i = 0; i < between.size(); ++i)
        between[i] += 0.25 * step * (vertices[i] - between[i]);
      moved = moved.deformed(between);
      prepared(moved);
    }
    const Mesh anew = fresh(moved);
    const Mesh other = tests::make_torus(0.8, 0.3, 24, 12);
    for (const PairVolume volume : {PairVolume::WideObb, PairVolume::Aabb}) {
      EXPECT_LT(static_cast<double>(tests_of(moved, other, volume)),
                1.4 * static_cast<double>(tests_of(anew, other, volume)));
    }
  }
}

TEST(Deform, IsSafeBesideQueries) {
  RandomSource source(908);
  const Mesh first = tests::make_sphere(1, 60, 60);
  const Mesh other = tests::make_torus(0.8, 0.3, 30, 15);
  const Vertices vertices = with_noise(vertices_of(first), 0.01, source);
  const Vertices later = with_noise(vertices_of(first), 0.05, source);
  const Mesh moved = first.deformed(vertices);
  const std::size_t expected = find_triangle_pairs({fresh(moved)}, {other}).size();
  const std::size_t expected_later =
      find_triangle_pairs({Mesh(later, first.triangles())}, {other}).size();
  find_triangle_pairs({first}, {other});
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  const Mesh shared = first.deformed(vertices);
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int n = 0; n < 4; ++n) {
        if ((n + t) % 2 == 0) {
          wrong += find_triangle_pairs({shared}, {other}).size() != expected;
        } else {
          wrong += find_triangle_pairs({shared.deformed(later)}, {other}).size() != expected_later;
        }
      }
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(wrong, 0);
}

TEST(Law10Deform, RefusesOtherCountsAndWhatIsNotFinite) {
  const Mesh mesh = tests::make_box({1, 1, 1});
  Vertices vertices = vertices_of(mesh);
  const auto message_of = [&] {
    try {
      mesh.deformed(vertices);
    } catch (const MeshError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(message_of(), "none");
  vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of(), "vertex 3: a coordinate is not finite");
  vertices.pop_back();
  EXPECT_EQ(message_of(), "deformed: 7 vertices for a mesh of 8");
}

TEST(Deform, SharesTrianglesAndNothingThatMoved) {
  const Mesh mesh = tests::make_box({1, 1, 1});
  EXPECT_EQ(mesh.topology().components, 1u);
  Vertices vertices = vertices_of(mesh);
  for (Eigen::Vector3d& p : vertices)
    p *= 3;
  vertices[0] = vertices[1];
  const Mesh moved = mesh.deformed(vertices);
  EXPECT_EQ(moved.triangles().data(), mesh.triangles().data());
  EXPECT_FALSE(moved == mesh);
  EXPECT_EQ(moved.bounds().max, Eigen::Vector3d(3, 3, 3));
  EXPECT_EQ(mesh.bounds().max, Eigen::Vector3d(1, 1, 1));
  EXPECT_EQ(moved.topology().welded_vertices, 7u);
  EXPECT_GT(moved.topology().degenerate_triangles, 0u);
}

}  // namespace
}  // namespace graze

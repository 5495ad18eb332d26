// A memory changes no answer.

#include <graze/engine/mesh/pair_memory.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_distance.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/narrowphase/simd_targets.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

/// A little further on a path: turned, and moved by about `step` of the size.
Pose moved(const Pose& pose, double step, double size, RandomSource& source) {
  const Pose by = tests::random_pose(step * size, source);
  Pose next = pose;
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond::Identity().slerp(step, Eigen::Quaterniond(by.linear()));
  next.linear() = (Eigen::Quaterniond(pose.linear()) * turn).normalized().toRotationMatrix();
  next.translation() += by.translation();
  return next;
}

struct Counts {
  int hits = 0;
  int misses = 0;
};

void expect_same(const MeshDistance& found, const MeshDistance& expected) {
  EXPECT_EQ(found.distance, expected.distance);
  EXPECT_EQ(found.pair, expected.pair);
  EXPECT_EQ(found.point_a, expected.point_a);
  EXPECT_EQ(found.point_b, expected.point_b);
}

/// One memory for each question, and one for all of them in turn.
struct Memories {
  PairMemory any, pairs, limited, shared, distance, within, all;
  Work work;
};

/// Every question in one pose, with a memory and without. Whether they meet.
bool expect_no_difference(const PlacedMesh& a, const PlacedMesh& b, double clearance,
                          Memories& memories) {
  Work* work = &memories.work;
  const TrianglePairs expected = find_triangle_pairs(a, b);
  const bool is_hit = !expected.empty();
  EXPECT_EQ(intersects(a, b, memories.any, {}, work), is_hit);
  EXPECT_EQ(intersects(a, b, memories.all), is_hit);
  EXPECT_EQ(find_triangle_pairs(a, b, memories.pairs, {}, work).pairs, expected.pairs);
  EXPECT_EQ(find_triangle_pairs(a, b, memories.all).pairs, expected.pairs);
  EXPECT_EQ(find_triangle_pairs(a, b, memories.shared, {.threads = 2}).pairs, expected.pairs);
  const TrianglePairs some = find_triangle_pairs(a, b, memories.limited, {.limit = 7});
  const TrianglePairs expected_some = find_triangle_pairs(a, b, {.limit = 7});
  EXPECT_EQ(some.pairs, expected_some.pairs);
  EXPECT_EQ(some.completeness, expected_some.completeness);
  EXPECT_EQ(intersects(a, b, memories.all, {.hit = Hit::Crossing}),
            intersects(a, b, {.hit = Hit::Crossing}));
  const MeshDistance nearest = distance(a, b);
  expect_same(distance(a, b, memories.distance, {}, work), nearest);
  expect_same(distance(a, b, memories.all), nearest);
  EXPECT_EQ(within(a, b, clearance, memories.within, {}, work), nearest.distance <= clearance);
  for (const double other : {nearest.distance, 0.5 * nearest.distance, 2 * clearance})
    EXPECT_EQ(within(a, b, other, memories.all), nearest.distance <= other);
  return is_hit;
}

void expect_brute_force(const PlacedMesh& a, const PlacedMesh& b, PairMemory& memory) {
  std::vector<TrianglePair> pairs;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < a.mesh.triangles().size(); ++i) {
    const Triangle triangle_a = place(a.pose, a.mesh.triangle(i));
    for (std::uint32_t j = 0; j < b.mesh.triangles().size(); ++j) {
      const Triangle triangle_b = place(b.pose, b.mesh.triangle(j));
      if (intersects(triangle_a, triangle_b)) pairs.push_back({i, j});
      if (pairs.empty()) least = std::min(least, distance(triangle_a, triangle_b).distance);
    }
  }
  EXPECT_EQ(find_triangle_pairs(a, b, memory).pairs, pairs);
  EXPECT_EQ(distance(a, b, memory).distance, pairs.empty() ? least : 0);
}

struct WalkSettings {
  double size = 1;  // of the meshes
  int jumps = 12;
};

/// A walk of poses that now and then jumps.
Counts walk(const Mesh& a, const Mesh& b, const WalkSettings& settings, Memories& memories,
            RandomSource& source) {
  const double size = settings.size;
  Counts counts;
  PairMemory beside_brute_force;
  Pose pose_a = tests::random_pose(0.1 * size, source);
  for (int jump = 0; jump < settings.jumps; ++jump) {
    Pose pose_b = tests::random_pose(1.1 * size, source);
    const double step = jump % 3 == 0 ? 0.03 : 0.0005;
    for (int i = 0; i < 25; ++i) {
      const bool is_hit = expect_no_difference({a, pose_a}, {b, pose_b}, 0.05 * size, memories);
      ++(is_hit ? counts.hits : counts.misses);
      if (i % 24 == 23) expect_brute_force({a, pose_a}, {b, pose_b}, beside_brute_force);
      pose_b = moved(pose_b, step, size, source);
      if (i % 2 == 0) pose_a = moved(pose_a, 0.5 * step, size, source);
    }
  }
  return counts;
}

TEST(Law9, AMemoryChangesNoAnswer) {
  RandomSource source(21);
  const Mesh torus = tests::make_torus(1, 0.3, 20, 12);
  const Mesh ball = tests::make_sphere(0.4, 10, 10);
  const Mesh soup = tests::random_soup({.count = 60, .extent = 0.2, .size = 0.1}, source);
  std::uint64_t still_apart = 0;
  for (const Mesh& other : {ball, soup}) {
    Memories memories;
    const Counts counts = walk(torus, other, {}, memories, source);
    EXPECT_GT(counts.hits, 20);
    EXPECT_GT(counts.misses, 20);
    EXPECT_GT(memories.any.still_touching(), 20u);
    EXPECT_GT(memories.within.still_touching(), 20u);
    EXPECT_GT(memories.work.skipped_by_memory, 1000u);
    still_apart += memories.any.still_apart();
  }
  EXPECT_GT(still_apart, 5u);
}

/// Steps along which planes hold for long: B turns on the spot, about an axis far from it, on a
/// screw, there and back, or both move as one. All of it far from the origin of the meshes.
TEST(Law9, AMemoryFollowsMotionsThatHardlyChangeGaps) {
  RandomSource source(27);
  const auto moved_off = [](const Mesh& mesh) {
    std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
    for (Eigen::Vector3d& vertex : vertices)
      vertex += Eigen::Vector3d(40, -70, 25);
    return Mesh(vertices, mesh.triangles());
  };
  const Mesh torus = moved_off(tests::make_torus(1, 0.3, 24, 16));
  const Mesh ball = moved_off(tests::make_sphere(0.5, 12, 12));
  const Eigen::Vector3d middle(40, -70, 25);
  Memories memories;
  PairMemory beside_brute_force;
  Counts counts;
  for (int motion = 0; motion < 20; ++motion) {
    const Pose start = tests::random_pose(0.7, source);
    const Eigen::Vector3d axis = source.vector(-1, 1).normalized();
    const Eigen::Vector3d way = 0.002 * source.vector(-1, 1);
    const double angle = motion % 2 == 0 ? 0.03 : 0.004;
    const bool is_common = motion % 5 == 4;
    for (int i = 0; i < 40; ++i) {
      const int step = motion % 4 == 3 && i > 20 ? 40 - i : i;
      Pose by = Pose::Identity();
      by.linear() = Eigen::AngleAxisd(angle * step, axis).toRotationMatrix();
      // About the middle, or about a point beside it.
      const Eigen::Vector3d about =
          middle + (motion % 3 == 0 ? 1.0 : 0.0) * Eigen::Vector3d(1, 1, 0);
      by.translation() = about - by.linear() * about + (motion % 3 == 1 ? step : 0) * way;
      Pose into = Pose::Identity();
      into.translation() = middle - start.linear() * middle + start.translation();
      into.linear() = start.linear();
      const PlacedMesh a{torus, is_common ? by : Pose::Identity()};
      const PlacedMesh b{ball, is_common ? Pose(by * into) : Pose(into * by)};
      ++(expect_no_difference(a, b, 0.05, memories) ? counts.hits : counts.misses);
      if (i % 13 == 12) expect_brute_force(a, b, beside_brute_force);
    }
  }
  EXPECT_GT(counts.hits, 50);
  EXPECT_GT(counts.misses, 50);
  EXPECT_GT(memories.work.skipped_by_memory, 1000u);
}

TEST(Law8, AMemoryChangesNoAnswerOnAnyTarget) {
  const Mesh torus = tests::make_torus(1, 0.3, 20, 12);
  const Mesh ball = tests::make_sphere(0.4, 10, 10);
  for (const std::int64_t target : narrowphase::simd_targets()) {
    narrowphase::force_simd_target(target);
    RandomSource source(28);
    Memories memories;
    const Counts counts = walk(torus, ball, {.jumps = 5}, memories, source);
    EXPECT_GT(counts.hits, 10) << target;
    EXPECT_GT(counts.misses, 10) << target;
    EXPECT_GT(memories.work.skipped_by_memory, 1000u) << target;
  }
  narrowphase::force_simd_target(0);
}

TEST(Law9, AMemoryChangesNoAnswerAtTheEndsOfDoubles) {
  RandomSource source(23);
  for (const double size : {1e-150, 1e140}) {
    const auto scaled = [&](const Mesh& mesh) {
      std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
      for (Eigen::Vector3d& vertex : vertices)
        vertex *= size;
      return Mesh(vertices, mesh.triangles());
    };
    Memories memories;
    const Mesh torus = scaled(tests::make_torus(1, 0.3, 8, 5));
    const Mesh ball = scaled(tests::make_sphere(0.4, 4, 4));
    const Counts counts = walk(torus, ball, {.size = size, .jumps = 6}, memories, source);
    EXPECT_GT(counts.hits, 5);
    EXPECT_GT(counts.misses, 5);
  }
}

/// Faces that slide in one plane, edges on edges, gaps of which many are equal: all by multiples of
/// 1/64, so that nothing is rounded.
TEST(Law9, AMemoryOfThingsThatJustTouch) {
  RandomSource source(24);
  const Mesh box = tests::make_box({1, 1, 1});
  const Mesh soup = tests::lattice_soup(60, 3, source);
  for (const Mesh& other : {box, soup}) {
    Memories memories;
    Pose pose = Pose::Identity();
    pose.translation() = Eigen::Vector3d(1.5, 0.25, 2.25);
    Counts counts;
    for (int i = 0; i < 120; ++i) {
      const bool is_hit = expect_no_difference({box}, {other, pose}, 0.25, memories);
      ++(is_hit ? counts.hits : counts.misses);
      const int axis = i < 40 ? 2 : i % 3;
      pose.translation()[axis] += i % 40 < 20 ? -1.0 / 64 : 1.0 / 64;
    }
    EXPECT_GT(counts.hits, 5);
  }
}

TEST(Law9, ACopyOfAMemoryGoesItsOwnWay) {
  const Mesh torus = tests::make_torus(1, 0.3, 20, 12);
  const Mesh ball = tests::make_sphere(0.4, 10, 10);
  PairMemory memory;
  PairMemory copy;
  Pose pose = Pose::Identity();
  Pose other = Pose::Identity();
  for (int i = 0; i < 60; ++i) {
    if (i == 20) copy = memory;
    pose.translation().x() = 0.6 + 0.001 * i;
    other.translation().y() = 0.5 + 0.002 * i;
    EXPECT_EQ(find_triangle_pairs({torus}, {ball, pose}, memory).pairs,
              find_triangle_pairs({torus}, {ball, pose}).pairs);
    EXPECT_EQ(find_triangle_pairs({torus}, {ball, other}, copy).pairs,
              find_triangle_pairs({torus}, {ball, other}).pairs);
  }
}

/// A small ball of small triangles in the side of a large box: nearly all pairs are told apart, or
/// to cross, in float, whatever their sizes.
TEST(Law9, AMemoryTellsLargeTrianglesFromSmallOnes) {
  const Mesh box = tests::make_box({1, 0.9, 0.8});
  const Mesh ball = tests::make_sphere(0.03, 40, 40);
  PairMemory memory;
  Work remembering;
  std::size_t pairs = 0;
  for (int i = 0; i < 200; ++i) {
    Pose pose(Eigen::AngleAxisd(0.01 * i, Eigen::Vector3d(1, 2, 3).normalized()));
    pose.translation() << 1.001, 0.3 - 0.001 * i, 0.1 + 0.0007 * i;
    const TrianglePairs expected = find_triangle_pairs({box}, {ball, pose});
    EXPECT_EQ(find_triangle_pairs({box}, {ball, pose}, memory, {}, &remembering).pairs,
              expected.pairs);
    pairs += expected.size();
  }
  EXPECT_GT(pairs, 10000u);
  EXPECT_LT(remembering.triangle_tests, pairs / 4);
}

/// Steps so long that a look as far ahead would not be a float: B goes far away and comes back to
/// where it touches.
TEST(Law9, AMemoryOutlivesStepsBeyondFloats) {
  const Mesh ring = tests::make_torus(1, 0.3, 60, 30);
  const Eigen::AngleAxisd upright(EIGEN_PI / 2, Eigen::Vector3d::UnitX());
  for (const double away : {1e10, 1e18, 1e38, 1e100, 1e200}) {
    PairMemory memory;
    for (int round = 0; round < 2; ++round) {
      Pose pose(upright);
      for (int i = 0; i < 20; ++i) {
        pose.translation() << 1 + 0.002 * i, 0.05, 0;
        EXPECT_FALSE(intersects({ring}, {ring, pose}, memory));
      }
      pose.translation().x() = away;
      EXPECT_FALSE(intersects({ring}, {ring, pose}, memory));
      pose.translation().x() = 0.5;
      EXPECT_TRUE(intersects({ring}, {ring, pose}, memory)) << away << ", " << round;
    }
  }
}

/// Planes along slabs hold no longer than they may: shells come to touch on one side or the other.
TEST(Law8, AMemoryThatAsksSlabsChangesNoAnswerOnAnyTarget) {
  const Mesh shell = tests::make_sphere(1.02, 60, 30);
  const Mesh ball = tests::make_sphere(1, 60, 30);
  for (const std::int64_t target : narrowphase::simd_targets()) {
    narrowphase::force_simd_target(target);
    for (const double way : {-0.001, 0.001}) {
      PairMemory inside;
      PairMemory outside;
      int touching = 0;
      for (int i = 0; i < 30; ++i) {
        Pose pose(Eigen::AngleAxisd(0.3 + 0.001 * i, Eigen::Vector3d(1, 2, 3).normalized()));
        pose.translation() << way * i, 0.3 * way * i, -0.5 * way * i;
        const bool expected = intersects({shell}, {ball, pose});
        EXPECT_EQ(intersects({shell}, {ball, pose}, inside), expected) << target << " " << i;
        EXPECT_EQ(intersects({ball, pose}, {shell}, outside), expected) << target << " " << i;
        touching += expected;
      }
      EXPECT_GT(touching, 3);
      EXPECT_LT(touching, 27);
    }
  }
  narrowphase::force_simd_target(0);
}

TEST(Law9, AMemoryOfOtherMeshesIsForgotten) {
  const Mesh near = tests::make_box({1, 1, 1});
  const Mesh far = tests::make_box({0.25, 0.25, 0.25});
  Pose pose = Pose::Identity();
  PairMemory memory;
  for (int i = 0; i < 20; ++i) {
    pose.translation().x() = 1.9 + 0.001 * i;
    EXPECT_TRUE(intersects({near}, {near, pose}, memory));
    EXPECT_FALSE(intersects({near}, {far, pose}, memory));
    EXPECT_FALSE(intersects({far, pose}, {near}, memory));
    expect_same(distance({near}, {far, pose}, memory), distance({near}, {far, pose}));
    expect_same(distance({far, pose}, {near}, memory), distance({far, pose}, {near}));
  }
  EXPECT_EQ(memory.still_touching() + memory.still_apart(), 0u);
}

/// Of fine meshes, by steps of a part of a triangle's edge, all pairs: many begin and cease to meet
/// in each. A mesh beside itself, so that both have the same leaves, and far from where poses
/// begin.
TEST(Law9, AMemoryFollowsWhatMeets) {
  RandomSource source(30);
  const Mesh torus = tests::make_torus(1, 0.3, 90, 45);
  const Mesh soup = tests::random_soup({.count = 4000, .extent = 1, .size = 0.1}, source);
  for (const double offset : {0.0, 1e9}) {
    for (const Mesh& mesh : {torus, soup}) {
      PairMemory memory;
      Work cold;
      Work remembering;
      Pose pose = tests::random_pose(0.3, source);
      Pose far = Pose::Identity();
      far.translation() = Eigen::Vector3d(offset, -offset, 0.5 * offset);
      for (int i = 0; i < 40; ++i) {
        const PlacedMesh a{mesh, far};
        const PlacedMesh b{mesh, Pose(far * pose)};
        const TrianglePairs expected = find_triangle_pairs(a, b, {}, &cold);
        EXPECT_GT(expected.size(), 100u);
        const TrianglePairs found = find_triangle_pairs(a, b, memory, {}, &remembering);
        EXPECT_TRUE(found.pairs == expected.pairs) << i;  // too many to be printed
        pose = moved(pose, i == 20 ? 0.2 : 0.002, 1, source);
      }
      EXPECT_LT(remembering.volume_tests, cold.volume_tests);
      // Most of what crosses surely does so in float: unless that is too coarse so far away.
      if (offset == 0) {
        EXPECT_LT(remembering.triangle_tests, 2 * cold.triangle_tests);
      }
    }
  }
}

TEST(PairMemory, SolidsAreAskedForInsides) {
  const Mesh box = tests::make_box({1, 1, 1});
  const Mesh small = tests::make_box({0.25, 0.25, 0.25});
  Pose pose = Pose::Identity();
  PairMemory memory;
  for (int i = 0; i < 10; ++i) {
    pose.translation().x() = 0.001 * i;
    EXPECT_TRUE(intersects({box}, {small, pose}, memory, {.hit = Hit::Solid}));
    EXPECT_FALSE(intersects({box}, {small, pose}, memory));
  }
}

}  // namespace
}  // namespace graze

// What a memory saves, by counters: it looks at fewer boxes and triangles, and allocates nothing.

#include <graze/engine/mesh/pair_memory.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <new>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace {
thread_local std::size_t allocations = 0;
}

// All forms of new that are not aligned come here.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
// Sanitizers have a form of their own for this one.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace graze {
namespace {

TEST(PairMemory, CountsWhatItSaves) {
  const Mesh torus = tests::make_torus(1, 0.3, 60, 30);
  const Mesh ball = tests::make_sphere(0.4, 30, 30);
  Pose pose = Pose::Identity();
  PairMemory memory;
  Work cold;
  Work remembering;
  for (int i = 0; i < 30; ++i) {
    pose.translation().x() = 0.5 + 0.0005 * i;
    find_triangle_pairs({torus}, {ball, pose}, {}, &cold);
    find_triangle_pairs({torus}, {ball, pose}, memory, {}, &remembering);
  }
  EXPECT_EQ(cold.skipped_by_memory, 0u);
  EXPECT_LT(remembering.volume_tests, cold.volume_tests / 2);
  EXPECT_GT(remembering.skipped_by_memory, remembering.volume_tests);
}

/// What was nearest in another pose bounds nothing in one that has nothing to do with it.
TEST(PairMemory, JumpsCostWhatDistancesCost) {
  const Mesh ring = tests::make_torus(1, 0.3, 90, 45);
  const Mesh rod = tests::make_torus(1, 0.02, 90, 12);
  RandomSource source(12);
  PairMemory memory;
  Work cold, remembering;
  for (int i = 0; i < 60; ++i) {
    const Pose pose = tests::random_pose(3, source);
    const MeshDistance wanted = distance({ring}, {rod, pose}, {}, &cold);
    EXPECT_EQ(distance({ring}, {rod, pose}, memory, {}, &remembering).distance, wanted.distance);
  }
  EXPECT_LT(remembering.volume_tests, 2 * cold.volume_tests);
  EXPECT_LT(remembering.triangle_tests, 2 * cold.triangle_tests);
}

/// Two linked rings that slide through each other's holes: their boxes overlap, and one look that
/// opens them answers several queries.
TEST(PairMemory, LooksAheadWhereNothingMeets) {
  const Mesh ring = tests::make_torus(1, 0.3, 60, 30);
  const Eigen::AngleAxisd upright(EIGEN_PI / 2, Eigen::Vector3d::UnitX());
  PairMemory memory;
  constexpr int kQueries = 300;
  for (int i = 0; i < kQueries; ++i) {
    Pose pose(upright);
    pose.translation().x() = 1 + 0.2 * std::sin(0.01 * i);
    pose.translation().y() = 0.2 * std::cos(0.01 * i);
    EXPECT_FALSE(intersects({ring}, {ring, pose}, memory));
  }
  EXPECT_GT(memory.still_apart(), kQueries / 2);
}

/// Triangles that may be as near as the nearest are asked in each pose, those that share its corner
/// or edge. What keeps the others out is a plane: by how far all has moved alone thrice as many
/// would be asked as by a walk.
TEST(PairMemory, AsksFewDistances) {
  const Mesh torus = tests::make_torus(1, 0.3, 60, 30);
  const Mesh ball = tests::make_sphere(0.6, 30, 30);
  PairMemory memory;
  Work cold;
  Work remembering;
  for (int i = 0; i < 100; ++i) {
    Pose pose(Eigen::AngleAxisd(0.0003 * i, Eigen::Vector3d(1, 2, 3).normalized()));
    pose.translation() << 0.9 + 0.001 * i, 0.0005 * i, 0.95 + 0.0007 * i;
    const MeshDistance expected = distance({torus}, {ball, pose}, {}, &cold);
    const MeshDistance found = distance({torus}, {ball, pose}, memory, {}, &remembering);
    EXPECT_EQ(found.distance, expected.distance);
    EXPECT_EQ(found.pair, expected.pair);
  }
  EXPECT_LT(remembering.triangle_tests, 2 * cold.triangle_tests);
}

/// Shells so near each other that no look can answer two queries: to try costs little.
TEST(PairMemory, LooksNoFurtherThanPays) {
  const Mesh shell = tests::make_sphere(1.005, 40, 40);
  const Mesh ball = tests::make_sphere(1, 40, 40);
  PairMemory memory;
  Work cold;
  Work remembering;
  for (int i = 0; i < 100; ++i) {
    const Pose pose(Eigen::AngleAxisd(0.004 * i, Eigen::Vector3d::UnitZ()));
    EXPECT_FALSE(intersects({shell}, {ball, pose}, {}, &cold));
    EXPECT_FALSE(intersects({shell}, {ball, pose}, memory, {}, &remembering));
  }
  EXPECT_LT(remembering.volume_tests, cold.volume_tests / 4);
}

/// Where surfaces are nearly parallel slabs tell apart what boxes do not: a front that did not ask
/// them would have three times as many triangles to look at.
TEST(PairMemory, AsksSlabs) {
  const Mesh shell = tests::make_sphere(1.02, 80, 40);
  const Mesh ball = tests::make_sphere(1, 80, 40);
  PairMemory memory;
  Work cold;
  Work remembering;
  for (int i = 0; i < 60; ++i) {
    const Pose pose(Eigen::AngleAxisd(0.3 + 0.001 * i, Eigen::Vector3d(1, 2, 3).normalized()));
    EXPECT_FALSE(intersects({shell}, {ball, pose}, {}, &cold));
    EXPECT_FALSE(intersects({shell}, {ball, pose}, memory, {}, &remembering));
  }
  EXPECT_LT(remembering.filter_tests, cold.filter_tests / 8);
}

/// A small ball that runs along a ring, nearer to it than each step is long: a walk is over after a
/// few nodes, and a front has to look at as many triangles as the ball meets anew.
TEST(PairMemory, WalksWhereThatCostsLess) {
  const Mesh ring = tests::make_torus(1, 0.3, 96, 48);
  const Mesh ball = tests::make_sphere(0.02, 12, 12);
  PairMemory memory;
  Work cold;
  Work remembering;
  for (int i = 0; i < 300; ++i) {
    Pose pose = Pose::Identity();
    pose.translation() << 0.736 * std::cos(0.01 * i), 0.736 * std::sin(0.01 * i), 0.198;
    EXPECT_FALSE(intersects({ring}, {ball, pose}, {}, &cold));
    EXPECT_FALSE(intersects({ring}, {ball, pose}, memory, {}, &remembering));
  }
  EXPECT_GT(remembering.volume_tests, cold.volume_tests / 2);
  EXPECT_LT(remembering.filter_tests, 5 * cold.filter_tests);
}

TEST(Allocations, BooleanQueriesMakeNoneOnceTheTreesAreBuilt) {
  RandomSource source(22);
  const Mesh torus = tests::make_torus(1, 0.3, 60, 30);
  const Mesh ball = tests::make_sphere(0.4, 40, 40);
  std::vector<Pose> poses(200);
  for (Pose& pose : poses)
    pose = tests::random_pose(1.2, source);
  std::size_t made[2];
  for (std::size_t& count : made) {
    const std::size_t before = allocations;
    for (const Pose& pose : poses) {
      intersects({torus}, {ball, pose});
    }
    count = allocations - before;
  }
  EXPECT_GT(made[0], 0u);  // the trees: the counter counts
  EXPECT_EQ(made[1], 0u);
}

}  // namespace
}  // namespace graze

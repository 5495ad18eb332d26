#include <graze/bvh/error.h>
#include <graze/engine/mesh/pair_memory.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

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

/// A little further on a path: turned, and moved by about `step` metres.
Pose moved(const Pose& pose, double step, RandomSource& source) {
  const Pose by = tests::random_pose(step, source);
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

/// A walk of poses that now and then jumps.
Counts walk(const Mesh& a, const Mesh& b, double reach, PairMemory& memory, RandomSource& source) {
  Counts counts;
  PairMemory of_pairs;
  Pose pose_a = tests::random_pose(0.1, source);
  for (int jump = 0; jump < 30; ++jump) {
    Pose pose_b = tests::random_pose(reach, source);
    const double step = jump % 3 == 0 ? 0.03 : 0.0005;
    for (int i = 0; i < 25; ++i) {
      const bool expected = intersects({a, pose_a}, {b, pose_b});
      EXPECT_EQ(intersects({a, pose_a}, {b, pose_b}, memory), expected);
      EXPECT_EQ(find_triangle_pairs({a, pose_a}, {b, pose_b}, of_pairs).pairs,
                find_triangle_pairs({a, pose_a}, {b, pose_b}).pairs);
      ++(expected ? counts.hits : counts.misses);
      pose_b = moved(pose_b, step, source);
      if (i % 2 == 0) pose_a = moved(pose_a, 0.5 * step, source);
    }
  }
  return counts;
}

TEST(Law9, AMemoryChangesNoAnswer) {
  RandomSource source(21);
  const Mesh torus = tests::make_torus(1, 0.3, 30, 16);
  const Mesh ball = tests::make_sphere(0.4, 14, 14);
  const Mesh soup = tests::random_soup({.count = 80, .extent = 0.2, .size = 0.1}, source);
  std::uint64_t still_apart = 0;
  for (const Mesh& other : {ball, soup}) {
    PairMemory memory;
    const Counts counts = walk(torus, other, 1.1, memory, source);
    EXPECT_GT(counts.hits, 50);
    EXPECT_GT(counts.misses, 20);
    EXPECT_GT(memory.still_touching(), 20u);
    still_apart += memory.still_apart();
  }
  EXPECT_GT(still_apart, 5u);
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
  }
  EXPECT_EQ(memory.still_touching() + memory.still_apart(), 0u);
}

TEST(PairMemory, RefusesOtherVolumes) {
  const Mesh box = tests::make_box({1, 1, 1});
  PairMemory memory;
  EXPECT_THROW(intersects({box}, {box}, memory, {.volume = Volume::Obb}), InputError);
}

TEST(PairMemory, SolidsAreAskedForInsides) {
  const Mesh box = tests::make_box({1, 1, 1});
  const Mesh small = tests::make_box({0.25, 0.25, 0.25});
  Pose pose = Pose::Identity();
  PairMemory memory;
  for (int i = 0; i < 10; ++i) {
    pose.translation().x() = 0.001 * i;
    EXPECT_TRUE(intersects({box}, {small, pose}, memory, {.interior = Interior::Solid}));
    EXPECT_FALSE(intersects({box}, {small, pose}, memory));
  }
}

TEST(Allocations, BooleanQueriesMakeNoneOnceTheTreesAreBuilt) {
  RandomSource source(22);
  const Mesh torus = tests::make_torus(1, 0.3, 60, 30);
  const Mesh ball = tests::make_sphere(0.4, 40, 40);
  std::vector<Pose> poses;
  for (int i = 0; i < 200; ++i)
    poses.push_back(tests::random_pose(1.2, source));
  PairMemory memory;
  std::size_t made[2];
  for (std::size_t& count : made) {
    const std::size_t before = allocations;
    for (const Pose& pose : poses) {
      intersects({torus}, {ball, pose});
      intersects({torus}, {ball, pose}, memory);
    }
    count = allocations - before;
  }
  EXPECT_GT(made[0], 0u);  // the trees: the counter counts
  EXPECT_EQ(made[1], 0u);
}

}  // namespace
}  // namespace graze

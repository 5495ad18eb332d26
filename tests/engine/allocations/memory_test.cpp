// A PairMemory that a step was thrown out of: the same step asked again, and all after it, have the
// answers that they have without a memory.

#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/pair_memory.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/engine/allocations/failing_new.h"
#include "tests/engine/first_touch/digest.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze::tests {
namespace {

struct TwoMeshes {
  Mesh a, b;
};

/// Comes near, touches, goes through, and leaves.
Pose pose_of(int step) {
  Pose pose = at(1.75 - 0.004 * step, 0.05, 0.02 * step);
  pose.linear() = Eigen::AngleAxisd(0.01 * step, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

/// `memory` may be nullptr.
Digest ask_along(const TwoMeshes& meshes, int step, PairMemory* memory) {
  const PlacedMesh a{meshes.a}, b{meshes.b, pose_of(step)};
  Digest digest;
  const auto tell_pairs = [&](const TrianglePairs& pairs) {
    for (const TrianglePair& pair : pairs)
      digest << pair.a << pair.b;
  };
  const auto tell_distance = [&](const MeshDistance& found) { digest << found.distance; };
  if (memory != nullptr) {
    digest << intersects(a, b, *memory) << within(a, b, 0.05, *memory);
    if (step % 2 == 0) tell_pairs(find_triangle_pairs(a, b, *memory));
    if (step % 3 == 0) tell_distance(distance(a, b, *memory));
  } else {
    digest << intersects(a, b) << within(a, b, 0.05);
    if (step % 2 == 0) tell_pairs(find_triangle_pairs(a, b));
    if (step % 3 == 0) tell_distance(distance(a, b));
  }
  return digest;
}

constexpr int kSteps = 30;

/// The motion with the n-th allocation failing. Whether one did.
bool play_memory(const TwoMeshes& meshes, const std::vector<Digest>& expected, long n,
                 long& calls) {
  PairMemory memory;
  bool has_failed = false;
  calls = 0;
  for (int step = 0; step < kSteps; ++step) {
    const long left = n - calls;
    Digest answer;
    {
      const FailingNew armed(has_failed ? FailingNew::kNever : left);
      try {
        answer = ask_along(meshes, step, &memory);
      } catch (const std::bad_alloc&) {
        has_failed = true;
      }
      calls += armed.calls();
    }
    if (answer.size() == 0) answer = ask_along(meshes, step, &memory);
    EXPECT_TRUE(answer == expected[static_cast<std::size_t>(step)])
        << "allocation " << n << ", step " << step;
  }
  return has_failed;
}

void fail_allocations_of_memories(int rings, long most) {
  const TwoMeshes meshes{make_sphere(1, rings, rings + 2), make_torus(1, 0.3, 2 * rings, rings)};
  std::vector<Digest> expected;
  for (int step = 0; step < kSteps; ++step)
    expected.push_back(ask_along(meshes, step, nullptr));
  long count = 0, calls = 0;
  play_memory(meshes, expected, -1, count);
  EXPECT_GT(count, 50);
  for (long n = 1; n <= count; n = next_failure(n, count, most)) {
    const long before = live_blocks();
    EXPECT_TRUE(play_memory(meshes, expected, n, calls)) << n;
    EXPECT_EQ(live_blocks(), before) << n;
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Allocations, OfMemoriesMayFail) {
  fail_allocations_of_memories(8, 60);
}

TEST(AllocationsSlow, OfMemoriesMayFail) {
  fail_allocations_of_memories(8, 1000000);
  fail_allocations_of_memories(24, 1000000);
}

}  // namespace
}  // namespace graze::tests

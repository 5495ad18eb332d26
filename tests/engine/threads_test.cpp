#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/self.h>
#include <graze/engine/mesh/volume_query.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <thread>
#include <vector>

#include "tests/shapes/formula_meshes.h"

namespace graze {
namespace {

// Many threads meet a mesh that nobody has walked yet: one of them builds, all answer alike.
TEST(MeshThreads, ConcurrentFirstUseBuildsOnceAndAnswersAlike) {
  const Mesh a = tests::make_sphere(1, 60, 60);
  const Mesh b = tests::make_torus(1, 0.3, 60, 30);
  std::atomic<std::uint64_t> trees_built = 0;
  std::vector<TrianglePairs> found(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < found.size(); ++i) {
    threads.emplace_back([&, i] {
      Work work;
      const Mesh copy = a;
      found[i] = find_triangle_pairs({copy}, {b}, {}, &work);
      intersects({b}, Aabb{{0, 0, 0}, {1, 1, 1}}, &work);
      EXPECT_TRUE(copy.topology().is_closed);
      EXPECT_FALSE(self_intersects(b, &work));
      trees_built += work.trees_built;
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(trees_built, 3u);  // in wide nodes both, and that of B in binary ones
  EXPECT_FALSE(found[0].empty());
  for (const TrianglePairs& pairs : found)
    EXPECT_EQ(pairs.pairs, found[0].pairs);
}

// Queries inside a user's parallel loop: a thread that waits for a tree being built must not take
// up another iteration that waits for the same tree.
TEST(MeshThreads, FirstUseInsideAParallelLoopDoesNotDeadlock) {
  for (int round = 0; round < 20; ++round) {
    const Mesh mesh = tests::make_sphere(1, 100, 100);
    std::atomic<int> hits = 0;
    tbb::parallel_for(0, 64, [&](int i) {
      Pose pose = Pose::Identity();
      pose.translation().x() = 0.02 * (i + 1);
      hits += intersects({mesh}, {mesh, pose});
    });
    EXPECT_EQ(hits, 64);
  }
}

}  // namespace
}  // namespace graze

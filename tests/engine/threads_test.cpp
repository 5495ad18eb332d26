#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/mesh_intersection.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/self.h>
#include <graze/engine/mesh/separating_translation.h>
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

// Distances, intersections and contacts of meshes that all threads share.
TEST(MeshThreads, DistancesAndContactsAreAlikeOnAllThreads) {
  const Mesh a = tests::make_sphere(1, 24, 24);
  const Mesh b = tests::make_torus(1, 0.3, 24, 12);
  Pose beside = Pose::Identity();
  beside.translation() << 2.5, 0.1, 0.2;
  std::vector<MeshDistance> distances(6);
  std::vector<MeshContacts> contacts(distances.size());
  std::vector<SeparatingTranslation> separations(distances.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    threads.emplace_back([&, i] {
      distances[i] = distance({a}, {b, beside});
      EXPECT_TRUE(within({a}, {b, beside}, distances[i].distance, {.hint = distances[i].pair}));
      contacts[i] = find_contacts({a}, {b});
      separations[i] = separating_translation({a}, {b}, {0, 0, 1});
      EXPECT_FALSE(find_intersection({a}, {b}).curves.empty());
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_GT(distances[0].distance, 0);
  EXPECT_FALSE(contacts[0].empty());
  for (std::size_t i = 1; i < distances.size(); ++i) {
    EXPECT_EQ(distances[i].distance, distances[0].distance);
    EXPECT_EQ(distances[i].pair, distances[0].pair);
    EXPECT_EQ(contacts[i].points, contacts[0].points);
    ASSERT_EQ(contacts[i].size(), contacts[0].size());
    EXPECT_EQ(contacts[i][0].depth, contacts[0][0].depth);
    EXPECT_EQ(separations[i].distance, separations[0].distance);
  }
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

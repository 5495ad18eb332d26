#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/pairs/shared_walk.h>
#include <graze/engine/mesh/query/wide_query.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/shapes/formula_meshes.h"

namespace graze {
namespace {

/// Two spheres that meet in a ring, walked by many.
class SharedWalkTest : public testing::Test {
 protected:
  /// Walks until all is walked, and gives at each step even where nobody waits.
  std::size_t walk_all(bvh::WidePairWalk& walk, SharedWalk::Turn turn,
                       std::vector<TrianglePair>& found) {
    std::size_t turns = 0;
    Candidates candidates(Touch::Include, work_of_one());
    const auto on_pair = [&](TrianglePair pair) {
      found.push_back(pair);
      return bvh::Walk::Continue;
    };
    bvh::FoundPair places[bvh::WidePairWalk::kMany];
    for (; turn; turn = shared_.take(walk)) {
      ++turns;
      while (const std::size_t count = walk.next(places)) {
        query_.decide_found({places, count}, candidates, on_pair);
        shared_.give(walk);
      }
      turn.reset();
    }
    candidates.decide(on_pair);
    return turns;
  }

  static Work& work_of_one() {
    thread_local Work work;
    return work;
  }

  Work work_;
  Mesh mesh_ = tests::make_sphere(1, 80, 80);
  Pose pose_a_ = Pose::Identity();
  Pose pose_b_ = Pose(Eigen::Translation3d(0.7, 0.1, 0.2));
  PlacedMeshView a_{mesh_, pose_a_};
  PlacedMeshView b_{mesh_, pose_b_};
  WideQuery query_{a_, b_, work_};
  SharedWalk shared_;
};

TEST_F(SharedWalkTest, ManyWalkersFindEachPairOnce) {
  const std::vector<TrianglePair> expected = find_triangle_pairs(a_, b_).pairs;
  ASSERT_GT(expected.size(), 300u);
  std::vector<std::vector<TrianglePair>> found(4);
  std::atomic<std::size_t> turns = 0;
  bvh::WidePairWalk first = query_.walk(bvh::WidePairWalk::Goal::AllPairs);
  SharedWalk::Turn first_turn = shared_.begin();
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < found.size(); ++i) {
    others.emplace_back([&, i] {
      bvh::WidePairWalk walk = first.another();
      SharedWalk::Turn turn = shared_.take(walk);
      turns += walk_all(walk, std::move(turn), found[i]);
    });
  }
  turns += walk_all(first, std::move(first_turn), found[0]);
  for (std::thread& other : others)
    other.join();
  std::vector<TrianglePair> all;
  for (const std::vector<TrianglePair>& of_one : found)
    all.insert(all.end(), of_one.begin(), of_one.end());
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, expected);
  EXPECT_GT(turns, 10u);
}

TEST_F(SharedWalkTest, IsWantedWhileSomebodyWaitsInVain) {
  EXPECT_FALSE(shared_.is_wanted());
  bvh::WidePairWalk walk = query_.walk(bvh::WidePairWalk::Goal::AllPairs);
  SharedWalk::Turn turn = shared_.begin();
  bvh::WidePairWalk of_other = walk.another();
  std::thread other([&] {
    const SharedWalk::Turn taken = shared_.take(of_other);
    EXPECT_TRUE(taken);
  });
  while (!shared_.is_wanted())
    std::this_thread::yield();
  shared_.give(walk);
  EXPECT_TRUE(walk.is_over());  // the pair of roots was all
  other.join();
  EXPECT_FALSE(of_other.is_over());
  EXPECT_FALSE(shared_.is_wanted());
}

// Who waits must not wait for ever.
TEST_F(SharedWalkTest, AWalkThatThrowsEndsItsTurn) {
  std::thread other;
  try {
    const SharedWalk::Turn turn = shared_.begin();
    other = std::thread([&] {
      bvh::WidePairWalk walk = query_.walk(bvh::WidePairWalk::Goal::AllPairs);
      EXPECT_FALSE(shared_.take(walk));
    });
    while (!shared_.is_wanted())
      std::this_thread::yield();
    throw std::runtime_error("as when memory is used up");
  } catch (const std::runtime_error&) {
    other.join();
  }
}

}  // namespace
}  // namespace graze

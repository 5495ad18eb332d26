// What boxes cost: memory on every way of moving them, sorts while they come and go, and queries
// before an update.

#include <graze/engine/world/broad_phase.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "tests/engine/broad_phase/box_histories.h"

namespace graze {
namespace {

using test::Chance;

constexpr std::uint32_t kMany = 20000;
constexpr double kMostBytes = 64;

/// Boxes of side 1, each of which overlaps about one other.
struct Crowd {
  BroadPhase broad;
  Chance chance{3};
  double half;
  std::vector<BoxId> ids;
  std::vector<Aabb> boxes;

  explicit Crowd(std::uint32_t count) : half(std::cbrt(count)) {
    for (std::uint32_t i = 0; i < count; ++i) {
      boxes.push_back(random_box());
      ids.push_back(broad.add(boxes.back()));
    }
  }
  Aabb random_box() {
    Eigen::Vector3d low;
    for (int c = 0; c < 3; ++c)
      low[c] = chance.between(-half, half);
    return {low, low + Eigen::Vector3d::Ones()};
  }
  void step_all() {
    for (Aabb& box : boxes) {
      const Eigen::Vector3d step = Eigen::Vector3d::Constant(chance.between(-0.05, 0.05));
      box.min += step, box.max += step;
    }
  }
  void replace(std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t i = chance.below(static_cast<std::uint32_t>(ids.size()));
      broad.remove(ids[i]);
      boxes[i] = random_box();
      ids[i] = broad.add(boxes[i]);
    }
  }
  void teleport(std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t i = chance.below(static_cast<std::uint32_t>(ids.size()));
      boxes[i] = random_box();
      broad.move(ids[i], boxes[i]);
    }
  }
  std::vector<std::uint32_t> overlapping(const Aabb& box) const {
    std::vector<std::uint32_t> all;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (test::share_point(boxes[i], box)) all.push_back(ids[i].index);
    }
    std::sort(all.begin(), all.end());
    return all;
  }
  std::vector<std::uint32_t> found(const Aabb& box) const {
    std::vector<std::uint32_t> all;
    broad.find_overlapping(box, all);
    std::sort(all.begin(), all.end());
    return all;
  }
  double bytes() const {
    return static_cast<double>(broad.bytes_for_boxes()) / static_cast<double>(boxes.size());
  }
};

template <typename Move>
void expect_few_bytes(const Move& move) {
  Crowd crowd(kMany);
  crowd.broad.update();
  for (int frame = 0; frame < 4; ++frame) {
    crowd.step_all();
    move(crowd);
    EXPECT_LE(crowd.bytes(), kMostBytes) << "before the update of frame " << frame;
    crowd.broad.update();
    EXPECT_LE(crowd.bytes(), kMostBytes) << "after the update of frame " << frame;
  }
  EXPECT_GE(crowd.bytes(), 48) << "a box alone takes as much";
}

TEST(BroadPhaseMemory, OfSingleMoves) {
  expect_few_bytes([](Crowd& crowd) {
    for (std::size_t i = 0; i < crowd.ids.size(); ++i)
      crowd.broad.move(crowd.ids[i], crowd.boxes[i]);
  });
}

TEST(BroadPhaseMemory, OfFewSingleMoves) {
  expect_few_bytes([](Crowd& crowd) {
    for (std::size_t i = 0; i < crowd.ids.size() / 20; ++i)
      crowd.broad.move(crowd.ids[i], crowd.boxes[i]);
  });
}

TEST(BroadPhaseMemory, OfASpan) {
  expect_few_bytes([](Crowd& crowd) { crowd.broad.move(crowd.ids, crowd.boxes); });
}

TEST(BroadPhaseMemory, OfASpanAfterAnAdd) {
  expect_few_bytes([](Crowd& crowd) {
    crowd.broad.add(crowd.random_box());
    crowd.broad.move(crowd.ids, crowd.boxes);
  });
}

TEST(BroadPhaseMemory, OfAShuffledSpan) {
  expect_few_bytes([](Crowd& crowd) {
    std::vector<BoxId> ids(crowd.ids.rbegin(), crowd.ids.rend());
    std::vector<Aabb> boxes(crowd.boxes.rbegin(), crowd.boxes.rend());
    std::swap(ids[7], ids[4000]);
    std::swap(boxes[7], boxes[4000]);
    crowd.broad.move(ids, boxes);
  });
}

/// Boxes that go far are looked after like new ones: no block is left to span the way between.
TEST(BroadPhaseChurn, GoingFarSortsNeighboursAndNotAll) {
  Crowd crowd(kMany);
  crowd.broad.update();
  const std::uint64_t sorts = crowd.broad.work().sorts;
  for (int frame = 0; frame < 20; ++frame) {
    crowd.teleport(kMany / 80);
    crowd.broad.update();
  }
  EXPECT_EQ(crowd.broad.work().searches_for_movers, 20u);
  EXPECT_EQ(crowd.broad.work().sorts, sorts);
  EXPECT_GT(crowd.broad.work().groups_sorted, 20u);
  crowd.broad.move(crowd.ids, crowd.boxes);
  crowd.broad.update();
  EXPECT_EQ(crowd.broad.work().searches_for_all, 2u);
  BroadPhase fresh;
  for (const Aabb& box : crowd.boxes)
    fresh.add(box);
  fresh.update();
  EXPECT_LE(crowd.broad.work().blocks_met, 3 * fresh.work().blocks_met);
  const auto kept = crowd.broad.sorted_pairs(), again = fresh.sorted_pairs();
  EXPECT_TRUE(std::equal(kept.begin(), kept.end(), again.begin(), again.end()));
}

/// Where one box in ten is replaced or goes far, all pairs are searched, but seldom all is sorted.
TEST(BroadPhaseChurn, ManyAreSearchedAndSeldomSorted) {
  for (const bool goes_far : {false, true}) {
    Crowd crowd(kMany);
    crowd.broad.update();
    for (int frame = 0; frame < 20; ++frame) {
      goes_far ? crowd.teleport(kMany / 10) : crowd.replace(kMany / 10);
      crowd.broad.update();
    }
    EXPECT_EQ(crowd.broad.work().searches_for_all, 21u);
    EXPECT_LE(crowd.broad.work().sorts, 8u);
  }
}

/// A step in which one box in 40 is replaced sorts groups, not all.
TEST(BroadPhaseChurn, SortsNeighboursAndNotAll) {
  Crowd crowd(kMany);
  crowd.broad.update();
  const std::uint64_t sorts = crowd.broad.work().sorts;
  for (int frame = 0; frame < 60; ++frame) {
    crowd.replace(kMany / 80);
    crowd.broad.update();
  }
  EXPECT_EQ(crowd.broad.work().searches_for_all, 1u);
  EXPECT_EQ(crowd.broad.work().searches_for_movers, 60u);
  EXPECT_EQ(crowd.broad.work().sorts, sorts);
  EXPECT_GT(crowd.broad.work().groups_sorted, 60u);
  EXPECT_LE(crowd.bytes(), 1.2 * kMostBytes);
  // The order is still of use: a search for all meets not many more blocks than after a sort.
  std::vector<BoxPair> kept(crowd.broad.sorted_pairs().begin(), crowd.broad.sorted_pairs().end());
  crowd.broad.move(crowd.ids, crowd.boxes);
  crowd.broad.update();
  EXPECT_EQ(crowd.broad.work().searches_for_all, 2u);
  const auto again = crowd.broad.sorted_pairs();
  EXPECT_TRUE(std::equal(kept.begin(), kept.end(), again.begin(), again.end()));
  BroadPhase fresh;
  for (const Aabb& box : crowd.boxes)
    fresh.add(box);
  fresh.update();
  EXPECT_LE(crowd.broad.work().blocks_met, 3 * fresh.work().blocks_met);
  EXPECT_EQ(fresh.pairs().size(), again.size());
}

/// Boxes that come and go in a crowd, which no order survives, and queries between.
TEST(BroadPhaseChurn, EqualsBruteForce) {
  Crowd crowd(4000);
  for (int frame = 0; frame < 12; ++frame) {
    crowd.replace(frame % 3 == 2 ? 1500 : 60);
    for (int query = 0; query < 3; ++query) {
      Aabb box = crowd.random_box();
      box.max.x() += 5;
      ASSERT_EQ(crowd.found(box), crowd.overlapping(box));
    }
    crowd.broad.update();
    BroadPhase fresh;
    for (const Aabb& box : crowd.boxes)
      fresh.add(box);
    fresh.update();
    std::vector<BoxPair> named;
    for (const BoxPair& pair : fresh.pairs()) {
      const std::uint32_t s = crowd.ids[pair.a].index, t = crowd.ids[pair.b].index;
      named.push_back({std::min(s, t), std::max(s, t)});
    }
    std::sort(named.begin(), named.end());
    const auto pairs = crowd.broad.sorted_pairs();
    ASSERT_TRUE(std::equal(named.begin(), named.end(), pairs.begin(), pairs.end()));
  }
}

/// Every box has moved since the update, far: as if the update had been made.
TEST(BroadPhaseQueryThreads, BeforeAnUpdate) {
  Crowd crowd(3000);
  crowd.broad.update();
  for (int frame = 0; frame < 3; ++frame) {
    for (std::size_t i = 0; i < crowd.ids.size(); ++i) {
      crowd.boxes[i] = crowd.random_box();
      crowd.broad.move(crowd.ids[i], crowd.boxes[i]);
    }
    std::vector<Aabb> asked;
    for (int i = 0; i < 16; ++i)
      asked.push_back(crowd.random_box());
    std::vector<std::thread> threads;
    std::vector<int> wrong(4);
    for (std::size_t t = 0; t < wrong.size(); ++t) {
      threads.emplace_back([&, t] {
        for (std::size_t k = 0; k < asked.size(); ++k) {
          const Aabb& box = asked[(k + t) % asked.size()];
          wrong[t] += crowd.found(box) != crowd.overlapping(box);
          wrong[t] += crowd.broad.box(crowd.ids[k]).min != crowd.boxes[k].min;
        }
      });
    }
    for (std::thread& thread : threads)
      thread.join();
    EXPECT_EQ(wrong, std::vector<int>(4));
  }
}

}  // namespace
}  // namespace graze

// Law 8: every list, in its order, is the same for any number of threads and on any SIMD target.

#include <graze/engine/world/broad_phase.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "tests/engine/broad_phase/box_histories.h"
#include "tests/narrowphase/simd_targets.h"

namespace graze {
namespace {

using test::Chance;
using test::Habitat;

/// FNV-1a over the numbers of a list.
void mix(std::uint64_t& hash, std::span<const BoxPair> pairs) {
  for (const BoxPair& pair : pairs) {
    for (const std::uint32_t number : {pair.a, pair.b}) {
      hash ^= number;
      hash *= 0x100000001b3u;
    }
  }
}

struct Hashes {
  std::uint64_t lists = 0xcbf29ce484222325u;   // pairs() as they come, begun() and ended()
  std::uint64_t sorted = 0xcbf29ce484222325u;  // sorted_pairs() under the boxes' own names
};

struct RunSettings {
  Habitat habitat;
  std::uint32_t count = 700;
  int threads = 1;
  std::uint32_t first = 0;  // the box that is added first; the others follow in a circle
};

/// Frames in which all boxes move, some, a few, and none.
Hashes run(const RunSettings& settings) {
  const std::uint32_t count = settings.count;
  Chance chance(11);
  std::vector<Aabb> boxes;
  for (std::uint32_t i = 0; i < count; ++i) {
    boxes.push_back(test::random_box(settings.habitat, chance));
    if (settings.habitat == Habitat::Uniform) {
      boxes.back().min *= 3, boxes.back().max *= 3;
      boxes.back().max = boxes.back().min + Eigen::Vector3d::Constant(1.5);
    }
  }
  BroadPhase broad({.threads = settings.threads});
  std::vector<BoxId> ids(count);
  std::vector<std::uint32_t> name(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t which = (i + settings.first) % count;
    ids[which] = broad.add(boxes[which]);
    name[ids[which].index] = which;
  }
  Hashes result;
  std::vector<BoxPair> named;
  for (const std::uint32_t one_in : {1u, 1u, 3u, 100u, 100u, 1u, 2000u, 30u, 1u}) {
    std::vector<BoxId> moved;
    std::vector<Aabb> places;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!chance.one_in(one_in)) continue;
      boxes[i] = chance.one_in(50) ? test::random_box(settings.habitat, chance)
                                   : test::stepped(boxes[i], settings.habitat, chance);
      moved.push_back(ids[i]);
      places.push_back(boxes[i]);
    }
    broad.move(moved, places);
    broad.update();
    mix(result.lists, broad.pairs());
    mix(result.lists, broad.begun());
    mix(result.lists, broad.ended());
    named.clear();
    for (const BoxPair& pair : broad.pairs())
      named.push_back({std::min(name[pair.a], name[pair.b]), std::max(name[pair.a], name[pair.b])});
    std::sort(named.begin(), named.end());
    mix(result.sorted, named);
  }
  return result;
}

struct Golden {
  Habitat habitat;
  std::uint32_t count;
  std::uint64_t lists;
  std::uint64_t sorted;
};

constexpr Golden kGolden[] = {
    {Habitat::Uniform, 3000, 16686938481652219847u, 6247608111659979354u},
    {Habitat::Far, 700, 7013927292131623979u, 15497133138417783065u},
    {Habitat::Sizes, 700, 10446820131920861014u, 4635039447768114159u},
};

class BroadPhaseDeterminism : public testing::TestWithParam<Golden> {};

TEST_P(BroadPhaseDeterminism, Threads) {
  for (const int threads : {1, 2, 4, 8}) {
    const Hashes result =
        run({.habitat = GetParam().habitat, .count = GetParam().count, .threads = threads});
    EXPECT_EQ(result.lists, GetParam().lists) << threads << " threads";
    EXPECT_EQ(result.sorted, GetParam().sorted) << threads << " threads";
  }
}

TEST_P(BroadPhaseDeterminism, SimdTargets) {
  for (const std::int64_t target : narrowphase::simd_targets()) {
    narrowphase::force_simd_target(target);
    const Hashes result = run({.habitat = GetParam().habitat, .count = GetParam().count});
    narrowphase::force_simd_target(0);
    EXPECT_EQ(result.lists, GetParam().lists) << hwy::TargetName(target);
    EXPECT_EQ(result.sorted, GetParam().sorted) << hwy::TargetName(target);
  }
}

TEST_P(BroadPhaseDeterminism, OrderOfInsertion) {
  for (const std::uint32_t first : {1u, 234u, 699u}) {
    const Hashes result =
        run({.habitat = GetParam().habitat, .count = GetParam().count, .first = first});
    EXPECT_EQ(result.sorted, GetParam().sorted) << "first " << first;
  }
}

/// So many that threads share the work; for fewer all is done in one go.
TEST(BroadPhaseDeterminismOfThousands, Threads) {
  for (const int threads : {1, 2, 4, 8, std::numeric_limits<int>::max()}) {
    const Hashes result = run({.habitat = Habitat::Uniform, .count = 9000, .threads = threads});
    EXPECT_EQ(result.lists, 2831215926047155900u) << threads << " threads";
    EXPECT_EQ(result.sorted, 7803717494874428077u) << threads << " threads";
  }
}

/// Boxes come, go, and go far, few and many in a frame; queries between some of them.
Hashes run_churn(int threads) {
  constexpr std::uint32_t kCount = 9000;
  Chance chance(12);
  const auto random_box = [&] {
    Aabb box = test::random_box(Habitat::Uniform, chance);
    box.min *= 5;
    box.max = box.min + Eigen::Vector3d::Constant(2);
    return box;
  };
  BroadPhase broad({.threads = threads});
  std::vector<BoxId> ids;
  for (std::uint32_t i = 0; i < kCount; ++i)
    ids.push_back(broad.add(random_box()));
  broad.update();
  Hashes result;
  for (const std::uint32_t count : {1u, 20u, 200u, 200u, 1500u, 1500u, 30u, 4000u, 100u}) {
    for (std::uint32_t k = 0; k < count; ++k) {
      BoxId& id = ids[chance.below(kCount)];
      if (k % 2 == 0) {
        broad.remove(id);
        id = broad.add(random_box());
      } else {
        broad.move(id, random_box());
      }
    }
    std::vector<std::uint32_t> seen;
    if (count % 3 == 2) broad.find_overlapping(random_box(), seen);
    broad.update();
    mix(result.lists, broad.pairs());
    mix(result.lists, broad.begun());
    mix(result.lists, broad.ended());
    mix(result.sorted, broad.sorted_pairs());
  }
  EXPECT_GT(broad.work().groups_sorted, 10u);
  return result;
}

TEST(BroadPhaseDeterminismOfChurn, ThreadsAndSimdTargets) {
  const Hashes expected = {5836150949769115732u, 14568953455362542936u};
  for (const int threads : {1, 2, 8}) {
    const Hashes result = run_churn(threads);
    EXPECT_EQ(result.lists, expected.lists) << threads << " threads";
    EXPECT_EQ(result.sorted, expected.sorted) << threads << " threads";
  }
  for (const std::int64_t target : narrowphase::simd_targets()) {
    narrowphase::force_simd_target(target);
    const Hashes result = run_churn(1);
    narrowphase::force_simd_target(0);
    EXPECT_EQ(result.lists, expected.lists) << hwy::TargetName(target);
    EXPECT_EQ(result.sorted, expected.sorted) << hwy::TargetName(target);
  }
}

INSTANTIATE_TEST_SUITE_P(Habitats, BroadPhaseDeterminism, testing::ValuesIn(kGolden));

}  // namespace
}  // namespace graze

#include <graze/engine/mesh/query/sort_pairs.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <random>
#include <span>
#include <vector>

#include "tests/narrowphase/simd_targets.h"

namespace graze {
namespace {

std::vector<TrianglePair> random_pairs(std::size_t count, std::uint32_t range, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<TrianglePair> pairs(count);
  for (TrianglePair& pair : pairs) {
    pair.a = static_cast<std::uint32_t>(random()) % range;
    pair.b = 0xffffffff - static_cast<std::uint32_t>(random()) % range;
  }
  return pairs;
}

TEST(Law8, PairsAreSortedOnEveryTarget) {
  for (const std::int64_t target : narrowphase::simd_targets()) {
    narrowphase::force_simd_target(target);
    for (std::size_t count = 0; count <= kMostToRank; ++count) {
      std::vector<TrianglePair> pairs = random_pairs(count, 50, 7);
      std::vector<TrianglePair> expected = pairs;
      std::sort(expected.begin(), expected.end());
      sort_pairs(pairs);
      EXPECT_EQ(pairs, expected) << count << " " << target;
    }
  }
  narrowphase::force_simd_target(0);
}

TEST(SortPairs, AgreesWithTheStandardSort) {
  for (std::size_t count = 0; count < 3 * kMostToRank; ++count) {
    for (const std::uint32_t range : {1u, 5u, 1000u, 0x80000000u}) {
      std::vector<TrianglePair> pairs = random_pairs(count, range, range + 1);
      std::vector<TrianglePair> expected = pairs;
      std::sort(expected.begin(), expected.end());
      sort_pairs(pairs);
      EXPECT_EQ(pairs, expected) << count << " " << range;
    }
  }
}

TEST(RankSort, SaysWhetherAnyAreEqual) {
  for (const std::int64_t target : narrowphase::simd_targets()) {
    narrowphase::force_simd_target(target);
    for (std::size_t count = 2; count <= kMostToRank; ++count) {
      // Wherever they lie in memory.
      std::vector<std::uint64_t> memory(count + 1);
      const std::span<std::uint64_t> numbers(memory.data() + 1, count);
      for (std::size_t i = 0; i < count; ++i)
        numbers[i] = (i * 7919) % 1009 << 40;
      std::vector<std::uint64_t> sorted(count);
      ASSERT_TRUE(rank_sort(numbers, sorted.data())) << count << " " << target;
      std::vector<std::uint64_t> expected(numbers.begin(), numbers.end());
      std::sort(expected.begin(), expected.end());
      EXPECT_EQ(sorted, expected);
      numbers[0] = numbers[count - 1];
      EXPECT_FALSE(rank_sort(numbers, sorted.data())) << count << " " << target;
    }
  }
  narrowphase::force_simd_target(0);
}

}  // namespace
}  // namespace graze

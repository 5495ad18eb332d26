#include <graze/narrowphase/triangle_pair_batch.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tests/shapes/random_source.h"

namespace graze::narrowphase {
namespace {

struct Pair {
  Triangle a;
  Triangle b;
};

/// Pairs of every sort: apart, crossing, touching, coplanar, degenerate, tiny, huge, not finite.
std::vector<Pair> pairs_of_every_sort(std::size_t count) {
  RandomSource source(1);
  std::vector<Pair> pairs;
  for (std::size_t n = 0; n < count; ++n) {
    constexpr double kScales[] = {1, 1, 1e-80, 1e-160, 1e-310, 1e40, 1e150};
    const double scale = kScales[n % 7];
    const auto point = [&]() -> Eigen::Vector3d {
      return (n % 3 == 0 ? source.lattice_point(-2, 2) : source.vector(-1, 1)) * scale;
    };
    Pair pair{{point(), point(), point()}, {point(), point(), point()}};
    if (n % 11 == 0) pair.b.c = pair.b.b;
    if (n % 13 == 0) pair.b.a = pair.a.a;
    if (n % 17 == 0) pair.a.b.y() = n % 2 == 0 ? std::nan("") : HUGE_VAL;
    pairs.push_back(pair);
  }
  return pairs;
}

std::vector<std::uint32_t> found_apart(const std::vector<Pair>& pairs) {
  std::vector<std::uint32_t> masks;
  TrianglePairBatch batch;
  for (const Pair& pair : pairs) {
    batch.add(pair.a, pair.b);
    if (!batch.is_full()) continue;
    masks.push_back(find_apart(batch));
    batch.clear();
  }
  return masks;
}

/// The SIMD targets that this CPU has, each forced in turn.
std::vector<std::int64_t> targets() {
  hwy::SetSupportedTargetsForTest(0);
  std::vector<std::int64_t> single;
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1)
    single.push_back(left & -left);
  return single;
}

void force(std::int64_t target) {
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(Law8, EverySimdTargetFindsTheSamePairsApart) {
  const std::vector<Pair> pairs = pairs_of_every_sort(80000);
  const std::vector<std::uint32_t> expected = found_apart(pairs);
  const std::vector<std::int64_t> all = targets();
  EXPECT_GE(all.size(), 1u);
  for (std::int64_t target : all) {
    force(target);
    EXPECT_EQ(found_apart(pairs), expected) << hwy::TargetName(target);
  }
  force(0);
}

TEST(Law6, ABatchIsSureOnlyWhereTheTriageOfOnePairIs) {
  const std::vector<Pair> pairs = pairs_of_every_sort(80000);
  const std::vector<std::uint32_t> masks = found_apart(pairs);
  std::size_t apart = 0;
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    const bool is_apart = (masks[n / 8] >> n % 8 & 1) != 0;
    apart += is_apart;
    if (!is_apart) continue;
    ASSERT_EQ(triage(pairs[n].a, pairs[n].b), Verdict::Apart) << n;
  }
  EXPECT_GT(apart, 15000u) << "it should find most of those that a plane separates";
}

TEST(TrianglePairBatch, LanesWithoutAPairAreNeverReported) {
  TrianglePairBatch batch;
  const Triangle low{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Triangle high{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  EXPECT_EQ(find_apart(batch), 0u);
  for (std::size_t size = 1; size <= TrianglePairBatch::kCapacity; ++size) {
    batch.add(low, high);
    EXPECT_EQ(batch.size(), size);
    EXPECT_EQ(find_apart(batch), (1u << size) - 1);
  }
  EXPECT_TRUE(batch.is_full());
  batch.clear();
  batch.add(low, low);
  EXPECT_EQ(find_apart(batch), 0u);
  EXPECT_EQ(batch.triangle_a(0).b, low.b);
  EXPECT_EQ(batch.triangle_b(0).c, low.c);
}

}  // namespace
}  // namespace graze::narrowphase

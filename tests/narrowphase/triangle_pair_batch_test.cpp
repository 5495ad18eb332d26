#include <graze/bvh/error.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/triangle_pair/crossing_stages.h>
#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tests/narrowphase/simd_targets.h"
#include "tests/shapes/random_source.h"

namespace graze::narrowphase {
namespace {

struct Pair {
  Triangle a;
  Triangle b;
};

/// Moves B into A's plane, or next to it by as much as the bound of the determinants is.
void put_near_plane(Pair& pair, RandomSource& source) {
  const Eigen::Vector3d u = pair.a.b - pair.a.a, v = pair.a.c - pair.a.a;
  const double away = std::ldexp(u.norm(), -static_cast<int>(source.integer(40, 54)));
  for (Eigen::Vector3d* corner : {&pair.b.a, &pair.b.b, &pair.b.c}) {
    const double s = source.uniform(-1, 2), t = source.uniform(-1, 2);
    *corner = pair.a.a + s * u + t * v + source.vector(-1, 1) * away;
  }
}

void stretch(Pair& pair, Eigen::Index axis, double factor) {
  for (Triangle* triangle : {&pair.a, &pair.b}) {
    for (Eigen::Vector3d* corner : {&triangle->a, &triangle->b, &triangle->c})
      (*corner)[axis] *= factor;
  }
}

/// Pairs of every sort: apart, crossing, touching, coplanar, nearly so, degenerate, tiny, huge,
/// stretched, not finite.
std::vector<Pair> pairs_of_every_sort(std::size_t count) {
  RandomSource source(1);
  std::vector<Pair> pairs;
  for (std::size_t n = 0; n < count; ++n) {
    constexpr double kScales[] = {1, 1, 1e-80, 1e-100, 1e-160, 1e-310, 1e40, 1e150};
    const double scale = kScales[n % 8];
    const auto point = [&]() -> Eigen::Vector3d {
      return (n % 3 == 0 ? source.lattice_point(-2, 2) : source.vector(-1, 1)) * scale;
    };
    Pair pair{{point(), point(), point()}, {point(), point(), point()}};
    if (n % 5 == 0) put_near_plane(pair, source);
    if (n % 19 == 0) stretch(pair, static_cast<Eigen::Index>(n % 3), 1e50);
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

/// The verdicts of a batch, of rows, and of one against many, for blocks of eight pairs.
struct AllVerdicts {
  std::vector<std::uint32_t> batch, rows, one;

  bool operator==(const AllVerdicts&) const = default;
};

/// Rows of the second triangles of some pairs, or of the first.
class Columns {
 public:
  Columns(const std::vector<Pair>& pairs, Triangle Pair::*which) {
    for (const Pair& pair : pairs) {
      const Triangle& t = pair.*which;
      for (std::size_t row = 0; row < 9; ++row) {
        const auto k = static_cast<Eigen::Index>(row % 3);
        columns_[row].push_back((row < 3 ? t.a : row < 6 ? t.b : t.c)[k]);
      }
    }
  }

  TriangleRows rows() const {
    TriangleRows rows{{}, columns_[0].size()};
    for (std::size_t row = 0; row < 9; ++row)
      rows.row[row] = columns_[row].data();
    return rows;
  }

 private:
  std::vector<double> columns_[9];
};

void append(std::vector<std::uint32_t>& all, const std::vector<Verdicts>& some) {
  for (const Verdicts& verdicts : some) {
    EXPECT_EQ(verdicts.apart & verdicts.touching, 0u);
    all.push_back(verdicts.apart << 16 | verdicts.touching);
  }
}

AllVerdicts all_verdicts(const std::vector<Pair>& pairs) {
  AllVerdicts all;
  std::vector<Verdicts> verdicts((pairs.size() + 7) / 8);
  TrianglePairBatch batch;
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    batch.add(pairs[n].a, pairs[n].b);
    if (!batch.is_full() && n + 1 < pairs.size()) continue;
    verdicts[n / 8] = triage(batch);
    batch.clear();
  }
  append(all.batch, verdicts);
  const Columns a(pairs, &Pair::a), b(pairs, &Pair::b);
  triage(a.rows(), b.rows(), verdicts.data());
  append(all.rows, verdicts);
  triage(pairs[0].a, b.rows(), verdicts.data());
  append(all.one, verdicts);
  return all;
}

Verdict verdict_of_bit(const std::vector<std::uint32_t>& all, std::size_t n) {
  return verdict_of((all[n / 8] >> (16 + n % 8) & 1) != 0, (all[n / 8] >> n % 8 & 1) != 0);
}

TEST(Law8, EverySimdTargetFindsTheSamePairsApart) {
  const std::vector<Pair> pairs = pairs_of_every_sort(80000);
  const std::vector<std::uint32_t> expected = found_apart(pairs);
  const std::vector<std::int64_t> all = simd_targets();
  EXPECT_GE(all.size(), 1u);
  for (std::int64_t target : all) {
    force_simd_target(target);
    EXPECT_EQ(found_apart(pairs), expected) << hwy::TargetName(target);
  }
  force_simd_target(0);
}

TEST(Law8, EverySimdTargetGivesTheSameVerdicts) {
  const std::vector<Pair> pairs = pairs_of_every_sort(20005);
  const AllVerdicts expected = all_verdicts(pairs);
  for (std::int64_t target : simd_targets()) {
    force_simd_target(target);
    EXPECT_EQ(all_verdicts(pairs), expected) << hwy::TargetName(target);
  }
  force_simd_target(0);
}

/// One pair at a time compares coordinates besides: it may know more, never less.
bool agrees(Verdict of_many, Verdict of_one, const Triangle& a, const Triangle& b) {
  if (of_many == of_one) return true;
  return of_many == Verdict::Unsure && of_one == compare_coordinates(a, b);
}

TEST(Law6, ManyAtOnceAreJudgedAsEachAlone) {
  const std::vector<Pair> pairs = pairs_of_every_sort(20005);
  const AllVerdicts all = all_verdicts(pairs);
  std::size_t touching = 0;
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    const Verdict alone = triage(pairs[n].a, pairs[n].b);
    ASSERT_TRUE(agrees(verdict_of_bit(all.rows, n), alone, pairs[n].a, pairs[n].b)) << n;
    ASSERT_EQ(verdict_of_bit(all.batch, n), verdict_of_bit(all.rows, n)) << n;
    const Verdict first = triage(pairs[0].a, pairs[n].b);
    ASSERT_TRUE(agrees(verdict_of_bit(all.one, n), first, pairs[0].a, pairs[n].b)) << n;
    touching += verdict_of_bit(all.rows, n) == Verdict::Yes;
  }
  EXPECT_GT(touching, 500u);
}

bool is_finite(const Pair& pair) {
  const auto finite = [](const Triangle& t) {
    return t.a.allFinite() && t.b.allFinite() && t.c.allFinite();
  };
  return finite(pair.a) && finite(pair.b);
}

TEST(Law2, UnsurePairsAreDecidedAsByThemselves) {
  const std::vector<Pair> pairs = pairs_of_every_sort(20005);
  const AllVerdicts all = all_verdicts(pairs);
  std::size_t unsure = 0, hits = 0;
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    if (verdict_of_bit(all.batch, n) != Verdict::Unsure) continue;
    const auto& [a, b] = pairs[n];
    for (const Touch touch : {Touch::Include, Touch::Exclude}) {
      if (!is_finite(pairs[n])) {
        EXPECT_THROW(decide_unsure(a, b, touch), InputError) << n;
        continue;
      }
      const bool is_hit = decide_unsure(a, b, touch).is_hit;
      ASSERT_EQ(is_hit, decide(a, b, touch).is_hit) << n;
      ++unsure, hits += is_hit;
    }
  }
  EXPECT_GT(unsure, 5000u);
  EXPECT_GT(hits, 500u);
}

/// What the determinants know shows in no stage: coordinates decide, or exact arithmetic does.
TEST(UnsurePairs, AreNotTriagedOnceMore) {
  std::size_t known_to_determinants = 0;
  for (const Pair& pair : pairs_of_every_sort(20005)) {
    if (!is_finite(pair)) continue;
    const Verdict compared = compare_coordinates(pair.a, pair.b);
    const Decision included = decide_unsure(pair.a, pair.b, Touch::Include);
    ASSERT_EQ(included.stage == Stage::Exact, compared == Verdict::Unsure);
    const Decision excluded = decide_unsure(pair.a, pair.b, Touch::Exclude);
    ASSERT_EQ(excluded.stage == Stage::Exact, compared != Verdict::No);
    known_to_determinants +=
        compared == Verdict::Unsure && decide(pair.a, pair.b).stage == Stage::Triage;
  }
  EXPECT_GT(known_to_determinants, 2000u);
}

TEST(TriangleRows, AnyLengthIsReadToItsEndAndNoFurther) {
  std::vector<Pair> pairs = pairs_of_every_sort(40);
  for (std::size_t size = 0; size <= pairs.size(); ++size) {
    const std::vector<Pair> some(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(size));
    const Columns a(some, &Pair::a), b(some, &Pair::b);
    std::vector<Verdicts> verdicts((size + 7) / 8 + 1, Verdicts{77, 88});
    triage(a.rows(), b.rows(), verdicts.data());
    EXPECT_EQ(verdicts[(size + 7) / 8].apart, 77u) << "one too many was written";
    for (std::size_t n = size; n < (size + 7) / 8 * 8; ++n)
      EXPECT_EQ((verdicts[n / 8].apart | verdicts[n / 8].touching) >> n % 8 & 1, 0u);
    if (size > 0) {
      EXPECT_EQ(b.rows()[size - 1].c.x(), some.back().b.c.x());
    }
  }
}

TEST(Law6, ABatchIsSureOnlyWhereTheTriageOfOnePairIs) {
  const std::vector<Pair> pairs = pairs_of_every_sort(80000);
  const std::vector<std::uint32_t> masks = found_apart(pairs);
  std::size_t apart = 0;
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    const bool is_apart = (masks[n / 8] >> n % 8 & 1) != 0;
    apart += is_apart;
    if (!is_apart) continue;
    ASSERT_EQ(triage(pairs[n].a, pairs[n].b), Verdict::No) << n;
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

#include <graze/bvh/error.h>
#include <graze/narrowphase/volumes/aabb_overlap.h>
#include <graze/narrowphase/volumes/kdop_overlap.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tests/narrowphase/volumes/simd_targets.h"
#include "tests/narrowphase/volumes/volume_source.h"

namespace graze {
namespace {

constexpr int kSlabs = KDop<18>::kSlabs;

/// The k-DOP of a lattice box: sums of small integers are exact.
KDop<18> kdop_of(const Aabb& box) {
  KDop<18> kdop;
  for (std::size_t slab = 0; slab < kSlabs; ++slab) {
    kdop.min[slab] = kdop.max[slab] = 0;
    for (int i = 0; i < 3; ++i) {
      const int factor = kKDopDirections<18>[slab][static_cast<std::size_t>(i)];
      kdop.min[slab] += factor * (factor > 0 ? box.min[i] : box.max[i]);
      kdop.max[slab] += factor * (factor > 0 ? box.max[i] : box.min[i]);
    }
  }
  return kdop;
}

TEST(Law11Aabb, OverlapIsClosedAndExactInEachCoordinate) {
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(intersects(box, box));
  EXPECT_TRUE(intersects(box, Aabb{{1, 1, 1}, {2, 2, 2}}));
  EXPECT_TRUE(intersects(box, Aabb{{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}));
  for (int i = 0; i < 3; ++i) {
    Aabb beyond{{0, 0, 0}, {2, 2, 2}};
    beyond.min[i] = std::nextafter(1.0, 2.0);
    EXPECT_FALSE(intersects(box, beyond));
    EXPECT_FALSE(intersects(beyond, box));
    Aabb before{{-1, -1, -1}, {1, 1, 1}};
    before.max[i] = -0x1p-1074;
    EXPECT_FALSE(intersects(box, before));
    EXPECT_FALSE(intersects(before, box));
  }
}

// A common point, if any, is the largest minimum; and moving both boxes by whole numbers changes
// nothing.
TEST(Law11Aabb, OverlapIsACommonPointForAllNumbers) {
  for (Numbers kind : kEveryKind) {
    VolumeSource source(kind, 1);
    for (int n = 0; n < 3000; ++n) {
      const Aabb a = source.box(), b = source.box();
      const Eigen::Vector3d corner = a.min.cwiseMax(b.min);
      const bool is_common =
          (corner.array() <= a.max.array()).all() && (corner.array() <= b.max.array()).all();
      ASSERT_EQ(intersects(a, b), is_common);
      ASSERT_EQ(intersects(b, a), is_common);
      if (kind != Numbers::Lattice) continue;
      const Eigen::Vector3d way = source.point();
      ASSERT_EQ(intersects(Aabb{a.min + way, a.max + way}, Aabb{b.min + way, b.max + way}),
                is_common);
    }
  }
}

TEST(Law11KDop, EachSlabSeparatesAndTouchingCounts) {
  const KDop<18> kdop = kdop_of({{0, 0, 0}, {2, 2, 2}});
  EXPECT_TRUE(intersects(kdop, kdop));
  for (std::size_t slab = 0; slab < kSlabs; ++slab) {
    KDop<18> other = kdop;
    other.min[slab] = other.max[slab] = kdop.max[slab];
    EXPECT_TRUE(intersects(kdop, other));
    other.min[slab] = other.max[slab] = std::nextafter(kdop.max[slab], HUGE_VAL);
    EXPECT_FALSE(intersects(kdop, other)) << slab;
    EXPECT_FALSE(intersects(other, kdop)) << slab;
    other.min[slab] = other.max[slab] = std::nextafter(kdop.min[slab], -HUGE_VAL);
    EXPECT_FALSE(intersects(kdop, other)) << slab;
    EXPECT_FALSE(intersects(other, kdop)) << slab;
  }
}

// The k-DOPs of boxes tell apart exactly those boxes that are: bevels never do better, nor worse.
TEST(Law11KDop, OfBoxesIsAsBoxes) {
  VolumeSource source(Numbers::Lattice, 2);
  int hits = 0;
  for (int n = 0; n < 20000; ++n) {
    const Aabb a = source.box(), b = source.box();
    const bool is_hit = intersects(kdop_of(a), kdop_of(b));
    ASSERT_EQ(is_hit, intersects(a, b));
    ASSERT_EQ(intersects(kdop_of(b), kdop_of(a)), is_hit);
    hits += is_hit;
  }
  EXPECT_GT(hits, 2000);
  EXPECT_LT(hits, 18000);
}

// Two bars along opposite diagonals: their boxes overlap, a bevel separates them.
TEST(Law11KDop, BevelsSeparateWhatBoxesDoNot) {
  KDop<18> low = kdop_of({{0, 0, 0}, {4, 4, 4}});
  KDop<18> high = low;
  low.max[3] = 3;  // x + y <= 3
  high.min[3] = std::nextafter(3.0, 4.0);
  EXPECT_FALSE(intersects(low, high));
  high.min[3] = 3;
  EXPECT_TRUE(intersects(low, high));
}

// What keeps two k-DOPs apart, or is wrong with one, is one slab in one of its numbers: zeros of
// both signs, the least and the greatest numbers, what is not finite. The rest are [-1, 1].
TEST(Law11KDop, EverySimdTargetComparesAsDoublesCompare) {
  const double most = std::numeric_limits<double>::max(), least = 0x1p-1074;
  const std::vector<double> values = {0.0,        -0.0,      least,        -least,       0x1p-1022,
                                      -0x1p-1022, 1,         -1,           most,         -most,
                                      HUGE_VAL,   -HUGE_VAL, std::nan(""), -std::nan("")};
  KDop<18> whole;
  whole.min.fill(-1);
  whole.max.fill(1);
  const auto is_valid = [](double low, double high) {
    return std::isfinite(low) && std::isfinite(high) && low <= high;
  };
  for (const std::int64_t target : simd_targets()) {
    force_simd_target(target);
    for (std::size_t slab = 0; slab < kSlabs; ++slab) {
      for (std::size_t n = 0; n < values.size() * values.size(); ++n) {
        const double low = values[n / values.size()], high = values[n % values.size()];
        KDop<18> bad = whole;
        bad.min[slab] = low;
        bad.max[slab] = high;
        if (!is_valid(low, high)) {
          EXPECT_THROW(intersects(bad, whole), InputError) << low << ' ' << high;
          EXPECT_THROW(intersects(whole, bad), InputError) << low << ' ' << high;
          continue;
        }
        KDop<18> before = whole, after = whole;
        before.min[slab] = -most;
        before.max[slab] = low;
        after.min[slab] = high;
        after.max[slab] = most;
        ASSERT_EQ(intersects(before, after), high <= low) << low << ' ' << high << ' ' << slab;
        ASSERT_EQ(intersects(after, before), high <= low) << low << ' ' << high << ' ' << slab;
      }
    }
  }
  force_simd_target(0);
}

TEST(Law10SlabOverlap, BadVolumesAreRefused) {
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  const KDop<18> kdop = kdop_of(box);
  for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (int i = 0; i < 3; ++i) {
      Aabb low = box, high = box;
      low.min[i] = bad;
      high.max[i] = bad;
      EXPECT_THROW(intersects(box, low), InputError);
      EXPECT_THROW(intersects(high, box), InputError);
    }
    for (std::size_t slab = 0; slab < kSlabs; ++slab) {
      KDop<18> low = kdop, high = kdop;
      low.min[slab] = bad;
      high.max[slab] = bad;
      EXPECT_THROW(intersects(kdop, low), InputError);
      EXPECT_THROW(intersects(high, kdop), InputError);
    }
  }
  EXPECT_THROW(intersects(box, Aabb{{0, 0, 2}, {1, 1, 1}}), InputError);
  KDop<18> inverted = kdop;
  inverted.min[8] = inverted.max[8] + 1;
  EXPECT_THROW(intersects(inverted, kdop), InputError);
}

}  // namespace
}  // namespace graze

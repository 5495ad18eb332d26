#include <graze/narrowphase/volumes/aabb_overlap.h>
#include <graze/narrowphase/volumes/obb_overlap.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/narrowphase/volumes/obb_cases.h"
#include "tests/narrowphase/volumes/rational_boxes.h"

namespace graze {
namespace {

using oracle::Reading;

/// An aligned box of about the size and place of an oriented one; its corners are rounded, so that
/// its centre and half extents are no doubles.
Aabb aligned(const Obb& box) {
  return {box.pose.translation() - box.half_extents, box.pose.translation() + box.half_extents};
}

void check_borders(int each, std::uint64_t seed) {
  for (Lie lie : kEveryLie) {
    RandomSource random(seed + static_cast<std::uint64_t>(lie));
    for (int n = 0; n < each; ++n) {
      const ObbCase pair = random_case(lie, random);
      const Aabb box = aligned(pair.a);
      const double far = 4 * pair.size() + 1e-300 + 1e-6 * pair.a.pose.translation().norm();
      const Border border =
          find_border(0, far, [&](double s) { return intersects(box, pair.b_at(s)); });
      ASSERT_TRUE(intersects(pair.b_at(border.hit), box)) << name_of(lie);
      ASSERT_FALSE(intersects(pair.b_at(border.apart), box)) << name_of(lie);
      for (Reading reading : {Reading::Image, Reading::Transpose})
        ASSERT_TRUE(separation(box, pair.b_at(border.apart), reading).is_apart) << name_of(lie);
      // Where the aligned box is far from the origin its own size says little: take what it is.
      const double size = 0.5 * (box.max - box.min).sum() + pair.b.half_extents.sum();
      const double deviation = rotation_deviation(pair.b.pose);
      const double promised = (3e-14 + (deviation > 0x1p-51 ? 20 * deviation : 0)) * size + 1e-320;
      const oracle::Separation exact = separation(box, pair.b_at(border.hit), Reading::Image);
      ASSERT_LE(exact.sine_gap, promised) << name_of(lie);
    }
  }
}

TEST(Law11AabbObb, ApartIsTrueAndOverlapTightAtTheBorder) {
  check_borders(600, 1);
}

TEST(Law11AabbObbSlow, ApartIsTrueAndOverlapTightAtTheBorder) {
  check_borders(10000, 1000);
}

// On a lattice both tests are exact or nearly so: they agree, but for boxes that just touch.
TEST(Law11AabbObb, AgreesWithAlignedBoxesOnALattice) {
  RandomSource random(7);
  int hits = 0;
  for (int n = 0; n < 20000; ++n) {
    const Aabb a{random.lattice_point(-4, 0), random.lattice_point(0, 4)};
    const Aabb b{random.lattice_point(-2, 2), random.lattice_point(2, 6)};
    Obb oriented{Pose::Identity(), 0.5 * (b.max - b.min)};
    oriented.pose.translation() = 0.5 * (b.min + b.max);
    ASSERT_EQ(intersects(a, oriented), intersects(a, b)) << n;
    hits += intersects(a, b);
  }
  EXPECT_GT(hits, 2000);
  EXPECT_LT(hits, 18000);
}

}  // namespace
}  // namespace graze

#include <graze/narrowphase/derived/directed_gap.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/shapes/random_source.h"

namespace graze::narrowphase {
namespace {

Triangle triangle_at(const Eigen::Vector3d& centre, double size, RandomSource& source) {
  const Eigen::Vector3d a = centre + size * source.vector(-1, 1);
  const Eigen::Vector3d b = centre + size * source.vector(-1, 1);
  return {a, b, centre + size * source.vector(-1, 1)};
}

TEST(Law6DirectedGap, NothingWithinTheLimitIsBeyondIt) {
  RandomSource source(66);
  int beyond = 0;
  for (int n = 0; n < 30000; ++n) {
    const double offset = n % 3 == 0 ? 0 : std::pow(10.0, source.integer(0, 12));
    const Eigen::Vector3d centre = offset * source.vector(-1, 1);
    const Triangle a = triangle_at(centre, 1, source);
    const Triangle b = triangle_at(centre + source.vector(-3, 3), 0.5, source);
    const Triangle neighbour = triangle_at(centre + source.vector(-3, 3), 0.5, source);
    DirectedGap gap(offset + 4);
    for (const Triangle& other : {b, neighbour}) {
      gap.set_direction(distance(a, other));
      const double exact = distance(a, b).distance;
      const double end = gap.end_of(a);
      const double start = gap.start_of(b);
      ASSERT_FALSE(gap.is_beyond(exact, end, start));
      ASSERT_FALSE(gap.is_beyond(2 * exact, end, start));
      beyond += gap.is_beyond(0.9 * exact, end, start);
    }
  }
  EXPECT_GT(beyond, 20000);
}

TEST(DirectedGap, WithoutADirectionNothingIsSure) {
  const Triangle a{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Triangle b{{0, 0, 9}, {1, 0, 9}, {0, 1, 9}};
  DirectedGap gap(10);
  EXPECT_FALSE(gap.is_beyond(1, gap.end_of(a), gap.start_of(b)));
  gap.set_direction(distance(a, b));
  EXPECT_TRUE(gap.is_beyond(1, gap.end_of(a), gap.start_of(b)));
  gap.set_direction(distance(a, a));
  EXPECT_FALSE(gap.is_beyond(1, gap.end_of(a), gap.start_of(b)));
  DirectedGap huge(1e300);
  huge.set_direction(distance(a, b));
  EXPECT_FALSE(huge.is_beyond(1, huge.end_of(a), huge.start_of(b)));
}

}  // namespace
}  // namespace graze::narrowphase

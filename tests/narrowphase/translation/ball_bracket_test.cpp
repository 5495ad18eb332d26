// What rounded arithmetic says of when a ball meets a triangle, beside rational arithmetic.

#include <graze/narrowphase/translation/ball_bracket.h>
#include <graze/narrowphase/volumes/spheres/triangle_sphere_stages.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/narrowphase/translation/random_balls.h"
#include "tests/narrowphase/translation/rational_ball.h"

namespace graze {
namespace {

using narrowphase::BallBracket;
using narrowphase::bracket_meeting;
using narrowphase::is_surely_met;

const Triangle kTable{{0, 0, 0}, {40, 0, 0}, {0, 40, 0}};

TEST(BallMet, IsOnlySaidOfWhatIsMet) {
  const Sphere ball{{5, 5, 3}, 1};
  EXPECT_FALSE(is_surely_met(kTable, ball, {0, 0, -8}, 0.25));
  EXPECT_TRUE(is_surely_met(kTable, ball, {0, 0, -8}, 0.26));
  EXPECT_FALSE(is_surely_met(kTable, ball, {0, 0, -8}, 0.6));  // gone through
  EXPECT_FALSE(is_surely_met(kTable, ball, {0, 0, 8}, 1));
  EXPECT_FALSE(is_surely_met(kTable, Sphere{{5, 5, 3}, 0}, {0, 0, -8}, 0.375));
  EXPECT_FALSE(is_surely_met(kTable, ball, {0, 0, -1e200}, 1));
  EXPECT_FALSE(is_surely_met(kTable, ball, {0, 0, -8}, std::nan("")));
}

TEST(BallBracketOfAMeeting, IsNarrowOnFacesEdgesAndCorners) {
  const auto expect_around = [](double time, const std::optional<BallBracket>& found) {
    ASSERT_TRUE(found);
    EXPECT_LT(found->low, time);
    EXPECT_GE(found->high, time);
    EXPECT_LT(found->high - found->low, 0x1p-40);
    EXPECT_GT(found->normal.z(), 0);
  };
  expect_around(0.25, bracket_meeting(kTable, Sphere{{5, 5, 3}, 1}, {0, 0, -8}));
  expect_around(0.5, bracket_meeting(kTable, Sphere{{5, -3, 8}, 5}, {0, 0, -8}));
  expect_around(0.5, bracket_meeting(kTable, Sphere{{-3, 0, 8}, 5}, {0, 0, -8}));
  EXPECT_FALSE(bracket_meeting(kTable, Sphere{{5, 5, 3}, 1}, {0, 0, 8}));
  EXPECT_FALSE(bracket_meeting(kTable, Sphere{{5, 5, 3}, 1}, {0, 0, -1}));
  EXPECT_FALSE(bracket_meeting(kTable, Sphere{{5, 5, 3}, 1}, {0, 0, 0}));
}

TEST(BallBracketOfAMeeting, HoldsTheRationalTime) {
  int met = 0, bracketed = 0;
  for (int kind = 0; kind < tests::kBallKinds; ++kind) {
    RandomSource source(static_cast<std::uint64_t>(kind) + 41);
    const int count = kind >= tests::kFirstLongBallKind ? 20 : 100;
    for (int n = 0; n < count; ++n) {
      const tests::BallQuery q = tests::random_ball_query(kind, source);
      if (intersects(q.triangle, q.ball)) continue;
      const auto found = bracket_meeting(q.triangle, q.ball, q.displacement);
      const auto right =
          oracle::rational_cast(q.triangle, q.ball, q.displacement, StartContact::Counts);
      met += right.contact.has_value();
      if (!found) continue;
      ++bracketed;
      ASSERT_TRUE(right.contact) << tests::name_of_ball_kind(kind) << " " << n;
      EXPECT_LT(right.time.compare(mpq_class(found->low)), 0)
          << tests::name_of_ball_kind(kind) << " " << n;
      EXPECT_GE(right.time.compare(mpq_class(found->high)), 0)
          << tests::name_of_ball_kind(kind) << " " << n;
      EXPECT_LE(found->high, 1);
    }
  }
  EXPECT_GT(3 * bracketed, met) << met;
}

}  // namespace
}  // namespace graze

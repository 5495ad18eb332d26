// Law 13 of a triangle and a ball beside a walk through time in rational arithmetic.

#include <graze/narrowphase/cast.h>
#include <gtest/gtest.h>

#include "tests/narrowphase/translation/random_balls.h"
#include "tests/narrowphase/translation/rational_ball.h"
#include "tests/narrowphase/translation/rational_cast.h"

namespace graze {
namespace {

using tests::BallQuery;

class Law13BallOracle : public testing::TestWithParam<int> {};

Triangle turned(const Triangle& t, int by) {
  const Eigen::Vector3d* p[3] = {&t.a, &t.b, &t.c};
  if (by >= 3) std::swap(p[0], p[1]);
  return {*p[by % 3], *p[(by + 1) % 3], *p[(by + 2) % 3]};
}

TEST_P(Law13BallOracle, IsAskedOfEachKindOfCast) {
  const int kind = GetParam();
  RandomSource source(static_cast<std::uint64_t>(kind) + 77);
  const int count = kind >= tests::kFirstLongBallKind ? 40 : 120;
  int contacts = 0;
  for (int n = 0; n < count; ++n) {
    const BallQuery q = tests::random_ball_query(kind, source);
    const int turn = static_cast<int>(source.integer(0, 5));
    for (const StartContact start : {StartContact::Counts, StartContact::IsLeft}) {
      const auto right = oracle::rational_cast(q.triangle, q.ball, q.displacement, start).contact;
      const auto found = cast(q.triangle, q.ball, q.displacement, {.start = start});
      ASSERT_EQ(found, right) << tests::name_of_ball_kind(kind) << " " << n << ": "
                              << oracle::text_of(q.triangle) << ", "
                              << oracle::text_of(q.ball.centre) << " " << q.ball.radius << ", "
                              << oracle::text_of(q.displacement)
                              << (start == StartContact::IsLeft ? ", left" : "") << "\n"
                              << (found ? found->time : -1) << " for "
                              << (right ? right->time : -1);
      EXPECT_EQ(cast(turned(q.triangle, turn), q.ball, q.displacement, {.start = start}), found);
      contacts += found.has_value();
    }
  }
  EXPECT_GT(contacts, 3) << tests::name_of_ball_kind(kind);
}

INSTANTIATE_TEST_SUITE_P(AllKinds, Law13BallOracle, testing::Range(0, tests::kBallKinds));

}  // namespace
}  // namespace graze

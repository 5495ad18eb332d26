// Law 13 of two triangles beside its definition in rational arithmetic.

#include <graze/narrowphase/cast.h>
#include <gtest/gtest.h>

#include "tests/narrowphase/translation/random_casts.h"
#include "tests/narrowphase/translation/rational_cast.h"

namespace graze {

namespace {

using tests::CastQuery;

class Law13Oracle : public testing::TestWithParam<int> {};

Triangle turned(const Triangle& t, int by) {
  const Eigen::Vector3d* p[3] = {&t.a, &t.b, &t.c};
  if (by >= 3) std::swap(p[0], p[1]);
  return {*p[by % 3], *p[(by + 1) % 3], *p[(by + 2) % 3]};
}

TEST_P(Law13Oracle, IsAskedOfEachKindOfCast) {
  const int kind = GetParam();
  RandomSource source(static_cast<std::uint64_t>(kind) + 1);
  const int count = kind >= 11 ? 60 : 250;
  int contacts = 0;
  for (int n = 0; n < count; ++n) {
    const CastQuery q = tests::random_cast(kind, source);
    const int turn_a = static_cast<int>(source.integer(0, 5));
    const int turn_b = static_cast<int>(source.integer(0, 5));
    for (const StartContact start : {StartContact::Counts, StartContact::IsLeft}) {
      const auto right = oracle::rational_cast(q.a, q.b, q.displacement, start).contact;
      const auto found = cast(q.a, q.b, q.displacement, {.start = start});
      ASSERT_EQ(found, right) << tests::name_of_cast_kind(kind) << " " << n << ": "
                              << oracle::text_of(q.a) << ", " << oracle::text_of(q.b) << ", "
                              << oracle::text_of(q.displacement)
                              << (start == StartContact::IsLeft ? ", left" : "") << "\n"
                              << (found ? found->time : -1) << " for "
                              << (right ? right->time : -1);
      EXPECT_EQ(cast(turned(q.b, turn_b), turned(q.a, turn_a), -q.displacement, {.start = start}),
                found);
      contacts += found && found->is_at_start == (kind == tests::kTouchingCasts);
    }
  }
  EXPECT_GT(contacts, 3) << tests::name_of_cast_kind(kind);
}

INSTANTIATE_TEST_SUITE_P(AllKinds, Law13Oracle, testing::Range(0, tests::kCastKinds));

}  // namespace
}  // namespace graze

// Law 12 with a clearance, beside its definition in rational arithmetic.

#include <graze/narrowphase/motion/near_contact.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/narrowphase/motion/random_clearances.h"
#include "tests/narrowphase/motion/random_paths.h"
#include "tests/narrowphase/motion/rational_contact.h"
#include "tests/narrowphase/motion/rational_nearness.h"

namespace graze {
namespace {

using tests::PathQuery;

class Law12Clearances : public testing::TestWithParam<int> {};

/// How many of the answers were contacts.
int compare(const PathQuery& query, const FirstContactSettings& settings) {
  const auto point = first_contact(query.point(), query.triangle(), settings);
  const auto edges = first_contact(query.edge_a(), query.edge_b(), settings);
  const auto right_point = oracle::rational_nearness(query.point(), query.triangle(), settings);
  const auto right_edges = oracle::rational_nearness(query.edge_a(), query.edge_b(), settings);
  EXPECT_EQ(point, right_point) << oracle::text_of(query.point()) << ", "
                                << oracle::text_of(query.triangle()) << ", " << settings.clearance
                                << "\n"
                                << oracle::text_of(point) << " for "
                                << oracle::text_of(right_point);
  EXPECT_EQ(edges, right_edges) << oracle::text_of(query.edge_a()) << ", "
                                << oracle::text_of(query.edge_b()) << ", " << settings.clearance
                                << "\n"
                                << oracle::text_of(edges) << " for "
                                << oracle::text_of(right_edges);
  EXPECT_EQ(first_contact(query.edge_b(), query.edge_a(), settings), edges);
  return int{point.has_value()} + int{edges.has_value()};
}

/// As many queries of one kind.
void ask_oracle(int kind, int count, std::uint64_t seed) {
  RandomSource source(seed);
  int contacts = 0;
  for (int n = 0; n < count && !testing::Test::HasFailure(); ++n) {
    const tests::ClearanceQuery query = tests::random_clearance(kind, source);
    for (const StartContact start : {StartContact::Counts, StartContact::IsLeft})
      contacts += compare(query.paths, {.start = start, .clearance = query.clearance});
  }
  EXPECT_GT(contacts, 0) << tests::name_of_clearance_kind(kind);
}

TEST_P(Law12Clearances, AreExactForEachKindOfPaths) {
  const int kind = GetParam();
  if (!tests::is_long_clearance_kind(kind))
    ask_oracle(kind, 5, static_cast<std::uint64_t>(kind) + 501);
}

using Law12ClearancesSlow = Law12Clearances;

TEST_P(Law12ClearancesSlow, AreExactForEachKindOfPaths) {
  const int kind = GetParam();
  ask_oracle(kind, tests::is_long_clearance_kind(kind) ? 10 : 100,
             static_cast<std::uint64_t>(kind) + 601);
}

INSTANTIATE_TEST_SUITE_P(AllKinds, Law12Clearances, testing::Range(0, tests::kClearanceKinds));
INSTANTIATE_TEST_SUITE_P(AllKinds, Law12ClearancesSlow, testing::Range(0, tests::kClearanceKinds));

}  // namespace
}  // namespace graze

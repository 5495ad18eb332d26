#include <gtest/gtest.h>

#include "tests/narrowphase/motion/random_paths.h"
#include "tests/narrowphase/motion/rational_contact.h"

namespace graze {
namespace {

using tests::PathQuery;

constexpr StartContact kStarts[] = {StartContact::Counts, StartContact::IsLeft};

class Law12Oracle : public testing::TestWithParam<int> {};

/// How many of the answers were contacts after the start.
int compare(const PathQuery& query, StartContact start, bool& agrees) {
  const FirstContactSettings settings{.start = start};
  const auto point = first_contact(query.point(), query.triangle(), settings);
  const auto edges = first_contact(query.edge_a(), query.edge_b(), settings);
  const auto right_point = oracle::rational_first_contact(query.point(), query.triangle(), start);
  const auto right_edges = oracle::rational_first_contact(query.edge_a(), query.edge_b(), start);
  const char* policy = start == StartContact::Counts ? "" : " left at the start";
  EXPECT_EQ(point, right_point) << oracle::text_of(query.point()) << ", "
                                << oracle::text_of(query.triangle()) << policy << "\n"
                                << oracle::text_of(point) << " for "
                                << oracle::text_of(right_point);
  EXPECT_EQ(edges, right_edges) << oracle::text_of(query.edge_a()) << ", "
                                << oracle::text_of(query.edge_b()) << policy << "\n"
                                << oracle::text_of(edges) << " for "
                                << oracle::text_of(right_edges);
  agrees = point == right_point && edges == right_edges;
  return (point && !point->is_at_start) + (edges && !edges->is_at_start);
}

TEST_P(Law12Oracle, IsAskedOfEachKindOfPaths) {
  const int kind = GetParam();
  RandomSource source(static_cast<std::uint64_t>(kind) + 1);
  const bool is_slow_oracle = kind == 10 || kind == 11;
  const int count = is_slow_oracle ? 6 : 120;
  int contacts = 0;
  for (int n = 0; n < count; ++n) {
    const PathQuery query = tests::random_paths(kind, source);
    for (StartContact start : kStarts) {
      bool agrees = true;
      contacts += compare(query, start, agrees);
      ASSERT_TRUE(agrees) << tests::name_of_path_kind(kind) << " " << n;
    }
  }
  if (!is_slow_oracle) {
    EXPECT_GT(contacts, 5) << tests::name_of_path_kind(kind);
  }
  RecordProperty("contacts", contacts);
}

INSTANTIATE_TEST_SUITE_P(AllKinds, Law12Oracle, testing::Range(0, tests::kPathKinds));

}  // namespace
}  // namespace graze

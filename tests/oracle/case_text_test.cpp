// Failure messages are cases: what is read from one is what was written, bit for bit.

#include <graze/engine/cases/read_case.h>
#include <gtest/gtest.h>
#include <tests/oracle/case_text.h>

#include <cmath>

namespace graze::oracle {
namespace {

TEST(CaseText, WhatIsWrittenIsRead) {
  const TrianglePair pair{{{0.1, -0.0, 1e300}, {1, 2, 3}, {4, 5, 6}},
                          {{7, 8, 9}, {-1, -2, -3}, {5e-324, 0, 1}}};
  const Case query = parse_case(to_text(pair, true), "case");
  EXPECT_EQ(query.ask, Ask::Any);
  EXPECT_EQ(query.answer->says, true);
  EXPECT_EQ(query.answered_by.engine, "referee");
  const Triangle& a = std::get<Triangle>(query.a);
  EXPECT_EQ(a.a, pair.a.a);
  EXPECT_TRUE(std::signbit(a.a.y()));
  EXPECT_EQ(std::get<Triangle>(*query.b).c, pair.b.c);
}

TEST(CaseText, BoxesToo) {
  const TriangleAndBox pair{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, {{-1, -1, -1}, {0x1p-1074, 0, 0.5}}};
  const Case query = parse_case(to_text(pair, false), "case");
  EXPECT_EQ(query.answer->says, false);
  EXPECT_EQ(std::get<Triangle>(query.a).b, pair.triangle.b);
  EXPECT_EQ(std::get<Aabb>(*query.b).max, pair.box.max);
}

}  // namespace
}  // namespace graze::oracle

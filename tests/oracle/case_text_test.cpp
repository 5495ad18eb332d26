#include <gtest/gtest.h>
#include <tests/files/temporary_directory.h>
#include <tests/oracle/case_text.h>

namespace graze::oracle {
namespace {

std::vector<KnownCase> read_text(const std::string& text) {
  const tests::TemporaryDirectory directory;
  return read_cases(directory.write("case.txt", text));
}

std::string message_of(const std::string& text) {
  try {
    read_text(text);
  } catch (const CaseError& error) {
    const std::string what = error.what();
    return what.substr(what.rfind("case.txt") + 8);
  }
  return "nothing thrown";
}

const std::string kBox =
    "triangle_box apart\n1 2 3  4 5 6  7 8 9\n-1 -1 -1  0x1p-1074 -0x0p+0 0.5\n";

TEST(CaseText, WhatIsWrittenIsRead) {
  const TrianglePair pair{{{0.1, -0.0, 1e300}, {1, 2, 3}, {4, 5, 6}},
                          {{7, 8, 9}, {-1, -2, -3}, {5e-324, 0, 1}}};
  const std::vector<KnownCase> cases = read_text("# why\n\n" + to_text(pair, true) + kBox);
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_TRUE(cases[0].intersects);
  EXPECT_EQ(cases[0].line, 3);
  EXPECT_EQ(to_text(std::get<TrianglePair>(cases[0].shapes), true), to_text(pair, true));
  EXPECT_FALSE(cases[1].intersects);
  const TriangleAndBox& box = std::get<TriangleAndBox>(cases[1].shapes);
  EXPECT_EQ(box.box.max.x(), 0x1p-1074);
  EXPECT_TRUE(std::signbit(box.box.max.y()));
}

TEST(CaseText, FaultsNameTheLine) {
  EXPECT_EQ(message_of(""), ":1: no case");
  EXPECT_EQ(message_of("# only a comment\n"), ":1: no case");
  EXPECT_EQ(message_of("\ntriangle_sphere apart\n"), ":2: unknown kind 'triangle_sphere'");
  EXPECT_EQ(message_of("triangle_box maybe\n"), ":1: unknown answer 'maybe'");
  EXPECT_EQ(message_of("triangle_box apart\n1 2 3\n4 five"), ":3: not a finite number: 'five'");
  EXPECT_EQ(message_of("triangle_box apart\n1 2 inf"), ":2: not a finite number: 'inf'");
  EXPECT_EQ(message_of("triangle_box apart\n1 2 3"), ":2: the file ends within a case");
  EXPECT_EQ(message_of(kBox + "1"), ":4: unknown kind '1'");
  EXPECT_THROW(read_cases("/no/such/file"), CaseError);
}

}  // namespace
}  // namespace graze::oracle

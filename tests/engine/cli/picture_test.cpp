// Pictures and pages of a comparison: lengths that can be read, and numbers from one source.

#include <graze/engine/cases/to_case.h>
#include <graze/engine/cli/compare/shell_word.h>
#include <graze/engine/cli/outlines/scale_bar.h>
#include <graze/engine/cli/outlines/svg_picture.h>
#include <graze/engine/compare/run/shrink_worst.h>
#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/engine/cli/compare/compare_fixture.h"

namespace graze::cli {
namespace {

TEST(ScaleBars, AreRoundAndAsLongAsMayBe) {
  EXPECT_EQ(scale_bar(3).label, "2 m");
  EXPECT_EQ(scale_bar(0.0049).label, "2 mm");
  EXPECT_EQ(scale_bar(0.0051).label, "5 mm");
  EXPECT_EQ(scale_bar(0.7).label, "500 mm");
  EXPECT_EQ(scale_bar(6e-6).label, "5 \u00b5m");
  EXPECT_EQ(scale_bar(15e-9).label, "10 nm");
  EXPECT_EQ(scale_bar(30e3).label, "20 km");
  EXPECT_EQ(scale_bar(1.5e-12).label, "1e-12 m");
  EXPECT_EQ(scale_bar(2.5e200).label, "2e200 m");
  for (double most = 1e-300; most < 1e300; most *= 1.7) {
    const ScaleBar bar = scale_bar(most);
    EXPECT_LE(bar.length, most);
    EXPECT_GT(bar.length, most / 2.51) << most;
  }
  for (const double none : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(scale_bar(none).length, 0) << none;
}

TEST(ShellWords, AreQuotedWhereTheyMustBe) {
  const std::vector<std::string> words = {"compare", "a b.off", "it's", "", "--seed", "1"};
  EXPECT_EQ(shell_line(words), "graze compare 'a b.off' 'it'\\''s' '' --seed 1");
}

TEST(Pictures, HaveAScaleBarInEachView) {
  const Triangle a{{0, 0, 0}, {0.004, 0, 0}, {0, 0.004, 0}};
  const Triangle b{{0.001, 0.001, -0.001}, {0.001, 0.001, 0.001}, {0.002, 0.002, 0.001}};
  const std::string picture = svg_picture(to_case(a, b, true));
  std::size_t bars = 0;
  for (std::size_t at = 0; (at = picture.find("class=\"bar\"", at)) != picture.npos; ++at)
    ++bars;
  EXPECT_EQ(bars, 2u);
  EXPECT_NE(picture.find(" mm</text>"), picture.npos) << picture;
  const Ray ray{{0.001, 0.001, 1}, {0, 0, -1}};
  EXPECT_NE(svg_picture(to_case(a, ray, cast_ray(a, ray))), "") << "a ray is drawn too";
}

/// The page says what ran, and its sections say the numbers of its table.
TEST_F(CliCompare, ThePageSaysWhatRan) {
  options_.query = "pairs";
  options_.seed = 5;
  options_.keep = 2;
  options_.report = directory_.path("report.html");
  options_.command = "graze compare a.off 'b c.off'";
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  const std::string page = read("report.html");
  for (const char* text :
       {"<th>command</th><td>graze compare a.off 'b c.off'</td>", "fcl planted",
        "<th>seed</th><td>5</td>", "<th>mesh A</th><td>SHA-256 ", "<th>mesh B</th><td>SHA-256 ",
        "<th>SIMD target of graze</th><td>", "<th>question</th><td>pairs</td>"}) {
    EXPECT_NE(page.find(text), page.npos) << text;
  }
  std::size_t sections = 0;
  for (std::size_t at = 0; (at = page.find("As it was asked: ", at)) != page.npos; ++sections) {
    const std::size_t begin = page.find("off by ", at) + 7;
    const std::string size = page.substr(begin, page.find(" m,", begin) - begin);
    EXPECT_NE(page.find("<td>" + size + "</td>"), page.npos) << size << " is not in the table";
    at = begin;
  }
  EXPECT_EQ(sections, 2u);
}

/// An engine that is wrong about meshes of several triangles, and about none of one.
TEST(LeastCases, SayThatTheyAreLeast) {
  const Mesh box = tests::make_box({1, 1, 1});
  compare::ShrunkCase shrunk{"bullet", 0, to_case({box}, {box}, true), {}};
  EXPECT_EQ(compare::least_size(shrunk),
            "cannot be shrunk further: 12 and 12 triangles, and without any one of them bullet is "
            "not wrong like this");
  shrunk.query = to_case(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                         Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, true);
  EXPECT_EQ(compare::least_size(shrunk), "");
}

}  // namespace
}  // namespace graze::cli

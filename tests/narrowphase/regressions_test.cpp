#include <graze/engine/compare/referee.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>
#include <tests/oracle/case_text.h>

#include <algorithm>

// Replays the lists of data/regressions; tests/compare replays the case files beside them. A wrong
// answer that is found anywhere becomes a case there.

namespace graze {
namespace {

using oracle::KnownCase;
using oracle::TriangleAndBox;
using oracle::TrianglePair;

struct Answers {
  bool is_hit;
  bool exact_stage;
  bool referee;
};

Answers answers(const TrianglePair& pair) {
  return {intersects(pair.a, pair.b), narrowphase::intersects_exactly(pair.a, pair.b),
          compare::referee_intersects(pair.a, pair.b)};
}

Answers answers(const TriangleAndBox& pair) {
  return {intersects(pair.triangle, pair.box),
          narrowphase::intersects_exactly(pair.triangle, pair.box),
          compare::referee_intersects(pair.triangle, pair.box)};
}

std::vector<std::filesystem::path> files() {
  std::vector<std::filesystem::path> result;
  for (const auto& entry : std::filesystem::directory_iterator(GRAZE_DATA_DIR "/regressions")) {
    if (entry.path().extension() == ".txt") result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

class Regressions : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Regressions, KeepTheirAnswers) {
  for (const KnownCase& known : oracle::read_cases(GetParam())) {
    const Answers found =
        std::visit([](const auto& shapes) { return answers(shapes); }, known.shapes);
    const std::string place = GetParam().filename().string() + ":" + std::to_string(known.line);
    EXPECT_EQ(found.is_hit, known.intersects) << place;
    EXPECT_EQ(found.exact_stage, known.intersects) << place;
    EXPECT_EQ(found.referee, known.intersects) << place << ": the file contradicts the referee";
  }
}

std::string name_of(const testing::TestParamInfo<std::filesystem::path>& info) {
  std::string name = info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Data, Regressions, testing::ValuesIn(files()), name_of);

}  // namespace
}  // namespace graze

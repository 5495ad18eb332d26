// Every case file of data/regressions is asked again, on every SIMD target: graze is right, and
// whoever was wrong is found so again.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/peers/engine.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <map>
#include <utility>

#include "tests/narrowphase/simd_targets.h"

namespace graze::compare {
namespace {

bool is_of_rounding(const std::string& class_name) {
  return class_name == name_of(ErrorClass::Touching) ||
         class_name == name_of(ErrorClass::PoseRounding);
}

/// The class that stands in brackets at the end of a note.
std::string class_in(const std::string& note) {
  const std::size_t begin = note.rfind('(');
  return begin == note.npos ? "" : note.substr(begin + 1, note.size() - begin - 2);
}

TEST(RegressionCases, KeepTheirVerdicts) {
  std::size_t cases = 0;
  std::map<std::pair<Ask, ErrorClass>, std::size_t> kinds;
  for (const auto& entry : std::filesystem::directory_iterator(GRAZE_DATA_DIR "/regressions")) {
    if (entry.path().extension() != ".json") continue;
    SCOPED_TRACE(entry.path().filename().string());
    ++cases;
    const Case query = read_case(entry.path());
    const Judge judge(query);
    const CaseAnswer first = answer_case(query);
    EXPECT_EQ(judge.judge(first, this_library()).verdict, Verdict::Right);
    for (const std::int64_t target : narrowphase::simd_targets()) {
      narrowphase::force_simd_target(target);
      EXPECT_TRUE(is_same(answer_case(query), first)) << target;
    }
    narrowphase::force_simd_target(0);

    ASSERT_TRUE(query.answer);
    const Judgement recorded = judge.judge(*query.answer, query.answered_by);
    const bool is_peer =
        query.answered_by.engine != "graze" && query.answered_by.engine != "referee";
    EXPECT_EQ(recorded.verdict, is_peer ? Verdict::Wrong : Verdict::Right);
    if (!is_peer) continue;
    const std::string found = name_of(recorded.error_class);
    const std::string noted = class_in(query.note);
    EXPECT_TRUE(found == noted || (is_of_rounding(found) && is_of_rounding(noted)))
        << found << ", not " << noted;
    ++kinds[{query.ask, recorded.error_class}];
    const std::optional<MeshCase> meshes = as_meshes(query);
    if (!meshes || query.answered_by.engine == "by hand") continue;
    EXPECT_LE(meshes->a.mesh.triangles().size() + meshes->b.mesh.triangles().size(), 2u);
  }
  EXPECT_GT(cases, 10u);
  for (const Ask ask : {Ask::Any, Ask::Pairs, Ask::Distance, Ask::Contacts})
    EXPECT_GT((kinds[{ask, ErrorClass::Real}]), 0u) << name_of(ask);
  for (const Ask ask : {Ask::Any, Ask::Distance, Ask::Within})
    EXPECT_GT((kinds[{ask, ErrorClass::Containment}]), 0u) << name_of(ask);
  EXPECT_GT((kinds[{Ask::Any, ErrorClass::Degenerate}]), 0u);
  for (const Ask ask : {Ask::FirstContact, Ask::Free})
    EXPECT_GT((kinds[{ask, ErrorClass::Real}]), 1u) << name_of(ask);
}

}  // namespace
}  // namespace graze::compare

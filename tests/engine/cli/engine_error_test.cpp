// Engines whose answers are none: triangles that are not there, no numbers, a throw. `graze
// compare` and `graze replay` say so, and go on.

#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/judgement.h>
#include <gtest/gtest.h>
#include <limits>

#include "tests/engine/cli/compare/compare_fixture.h"

namespace graze::cli {
namespace {

using compare::NoAnswer;

class CliEngineErrors : public CliCompare {
 protected:
  /// Compares with such an engine; graze is right all the same.
  void expect_error(NoAnswer kind, const std::string& query, const std::string& why) {
    SCOPED_TRACE(query + ": " + why);
    options_.query = query;
    options_.cases = directory_.path("found-" + query + std::to_string(static_cast<int>(kind)));
    options_.report = directory_.path("report.html");
    const auto engines = graze_and(compare::make_senseless_engine("odd", kind));
    EXPECT_EQ(compare(engines), ExitCode::Answered);
    EXPECT_NE(out_.find("engine error: " + why), out_.npos) << out_;
    ASSERT_EQ(found().size(), 1u) << out_;
    const Case kept = read_case(found().front());
    EXPECT_FALSE(kept.answer) << "what is no answer is in no file";
    EXPECT_NE(kept.note.find(why), kept.note.npos) << kept.note;
    EXPECT_NE(read("report.html").find("engine error: " + why), std::string::npos);
    const ExitCode code = run([&](Output& output) {
      return run_replay({.files = {found().front().string()}}, engines, output);
    });
    EXPECT_EQ(code, ExitCode::Answered);
    EXPECT_NE(out_.find("engine error: "), out_.npos) << out_;
  }
};

TEST_F(CliEngineErrors, AreNamedAndNeverACrash) {
  options_.grazing = 6;
  options_.random = 0;
  expect_error(NoAnswer::StrangeTriangle, "pairs", "names triangle 4294967295 of ");
  expect_error(NoAnswer::StrangeTriangle, "distance", "names triangle 4294967295 of ");
  expect_error(NoAnswer::Disorder, "pairs", "a list that does not ascend");
  expect_error(NoAnswer::NotANumber, "distance", "a distance that is no number");
  for (const char* query : {"any", "pairs", "distance"}) {
    expect_error(NoAnswer::AnotherPart, query, "answers another question");
    expect_error(NoAnswer::Throw, query, "throws out of its depth");
  }
}

TEST_F(CliEngineErrors, AreRecordedAndResumed) {
  options_.query = "distance";
  options_.resume = directory_.path("run.jsonl");
  const auto engines = graze_and(compare::make_senseless_engine("odd", NoAnswer::NotANumber));
  EXPECT_EQ(compare(engines), ExitCode::Answered);
  const std::string first = out_;
  EXPECT_EQ(compare(engines), ExitCode::Answered);
  EXPECT_EQ(out_, first) << "from the record alone";
}

/// Faults of every part, one by one.
TEST(EngineErrors, OfEachPart) {
  const Mesh box = tests::make_box({1, 1, 1});
  Case query = to_case({box}, {box}, true);
  const auto fault = [&](Ask ask, const CaseAnswer& answer) {
    query.ask = ask;
    return compare::fault_of_answer(query, answer).value_or("");
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  CaseAnswer answer;
  answer.pairs = {{0, 0}, {11, 11}};
  EXPECT_EQ(fault(Ask::Pairs, answer), "");
  answer.pairs = {{0, 12}};
  EXPECT_EQ(fault(Ask::Pairs, answer), "names triangle 12 of 12");
  answer.pairs = {{99, 0}};
  EXPECT_EQ(fault(Ask::Pairs, answer), "names triangle 99 of 12");
  answer.pairs = {{1, 0}, {0, 0}};
  EXPECT_EQ(fault(Ask::Pairs, answer), "a list that does not ascend");
  answer = {};
  answer.triangles = {{0, 11}};
  EXPECT_EQ(fault(Ask::Pairs, answer), "");
  answer.triangles = {{0, 12}};
  EXPECT_EQ(fault(Ask::Pairs, answer), "names triangle 12 of 12");
  answer.triangles = {{3, 3}};
  EXPECT_EQ(fault(Ask::Pairs, answer), "a list that does not ascend");
  answer = {};
  EXPECT_EQ(fault(Ask::Any, answer), "answers another question");
  EXPECT_EQ(fault(Ask::Ray, answer), "answers another question");
  answer.distance = infinity;
  EXPECT_EQ(fault(Ask::Distance, answer), "") << "beyond the largest double";
  answer.point_b = Eigen::Vector3d(0, nan, 0);
  EXPECT_EQ(fault(Ask::Distance, answer), "a point that is not finite");
  answer = {};
  answer.contacts.emplace();
  EXPECT_EQ(fault(Ask::Contacts, answer), "");
  answer.contacts = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}, infinity}};
  EXPECT_EQ(fault(Ask::Contacts, answer), "a contact that is not finite");
  const compare::Judgement judgement = compare::Judge(query).judge(answer, {"somebody", ""});
  EXPECT_EQ(judgement.verdict, compare::Verdict::Wrong);
  EXPECT_EQ(judgement.error_class, compare::ErrorClass::EngineError);
}

}  // namespace
}  // namespace graze::cli

// `graze replay`: what counts as wrong and what as changed, what is printed, and bad files among
// good ones.

#include <graze/bvh/error.h>
#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/replay/replay_run.h>
#include <gtest/gtest.h>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/compare/engine_doubles.h"
#include "tests/files/temporary_directory.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::cli {
namespace {

using compare::EngineEntry;

class CliReplay : public testing::Test {
 protected:
  static std::vector<EngineEntry> only_graze() {
    std::vector<EngineEntry> engines;
    engines.push_back({"graze", compare::make_graze_engine()});
    return engines;
  }

  static CaseMesh cube_at(double x) {
    Pose pose = Pose::Identity();
    pose.translation().x() = x;
    return {tests::make_box({1, 1, 1}), pose};
  }

  /// Cubes half a metre deep in each other, or a metre apart, and what somebody said of them.
  void write_any(const std::string& name, double x, bool says, const std::string& by) const {
    Case query = to_case(cube_at(0), cube_at(x), says);
    query.answered_by = {by, "0.0.9"};
    directory_.write(name, to_json(query));
  }
  void write_distance(const std::string& name, double distance, const std::string& by) const {
    Case query = to_case(cube_at(0), cube_at(3), true);
    query.ask = Ask::Distance;
    query.answer = CaseAnswer();
    query.answer->distance = distance;
    query.answered_by = {by, ""};
    directory_.write(name, to_json(query));
  }

  ExitCode replay(ReplayOptions options, const std::vector<EngineEntry>& engines = only_graze()) {
    options.files = {directory_.path().string()};
    std::FILE* stream = std::tmpfile();
    Output output(stream);
    testing::internal::CaptureStderr();
    const ExitCode code = run_replay(options, engines, output);
    err_ = testing::internal::GetCapturedStderr();
    out_.assign(static_cast<std::size_t>(std::ftell(stream)), ' ');
    std::rewind(stream);
    EXPECT_EQ(std::fread(out_.data(), 1, out_.size(), stream), out_.size());
    std::fclose(stream);
    return code;
  }

  void expect_summary(const std::string& line) const {
    EXPECT_NE(out_.find("\n" + line + "\n"), out_.npos) << out_;
  }

  tests::TemporaryDirectory directory_;
  std::string out_;
  std::string err_;
};

TEST_F(CliReplay, ABugThatWasFixedIsNoFailure) {
  write_any("old.json", 1.5, false, "graze");
  EXPECT_EQ(replay({}), ExitCode::Answered);
  expect_summary("1 case, graze wrong in 0, changed in 1");
  EXPECT_EQ(replay({.is_change_failure = true}), ExitCode::GrazeWrong);
}

TEST_F(CliReplay, ARecordOfTheRefereeThatIsWrongDoesNotMakeGrazeWrong) {
  write_any("referee.json", 1.5, false, "referee");
  EXPECT_EQ(replay({}), ExitCode::Answered);
  expect_summary("1 case, graze wrong in 0, changed in 1");
}

TEST_F(CliReplay, WhatIsWrongTodayIsOne) {
  write_any("now.json", 1.5, true, "graze");
  write_any("other.json", -3, false, "fcl");
  std::vector<EngineEntry> engines;
  engines.push_back({"graze", compare::make_inward_rounding_engine("graze", 10)});
  EXPECT_EQ(replay({}, engines), ExitCode::GrazeWrong);
  expect_summary("2 cases, graze wrong in 1, changed in 1");
}

/// Nobody says which of the two answers is right.
TEST_F(CliReplay, AChangeThatNobodyJudgesIsAFailure) {
  const CaseMesh cube(tests::make_box({1, 1, 1}), Pose::Identity());
  Case query = to_case(cube, cube, true);
  query.ask = Ask::SelfAny;  // about which nothing is judged
  query.b.reset();
  query.answered_by = {"graze", "0.0.9"};
  directory_.write("self.json", to_json(query));
  EXPECT_EQ(replay({}), ExitCode::GrazeWrong);
  expect_summary("1 case, graze wrong in 0, changed in 1");
}

TEST_F(CliReplay, TheTruthStandsBesideAnswersWithAllTheirDigits) {
  write_distance("far.json", 1 + 0x1p-40, "fcl");
  EXPECT_EQ(replay({}), ExitCode::Answered);
  EXPECT_NE(out_.find(" truth "), out_.npos);
  EXPECT_NE(out_.find(" apart by 1 m "), out_.npos) << out_;
  EXPECT_NE(out_.find(" 1.0000000000009095 m "), out_.npos) << out_;
}

/// An engine that gives no answer is named, so that nobody takes its silence for agreement.
TEST_F(CliReplay, EnginesThatKnowNoSuchQueryAreNamed) {
  const Ray ray{{-3, 0, 0.25}, {1, 0, 0}};
  const CaseMesh cube = cube_at(0);
  directory_.write("ray.json",
                   to_json(to_case(CaseShape(cube), ray, cast_ray({cube.mesh, cube.pose}, ray))));
  std::vector<EngineEntry> engines = only_graze();
  engines.push_back({"fcl", compare::make_inward_rounding_engine("fcl", 0)});
  EXPECT_EQ(replay({}, engines), ExitCode::Answered);
  EXPECT_NE(out_.find(" fcl    knows no such query"), out_.npos) << out_;
  EXPECT_EQ(replay({.is_json = true}, engines), ExitCode::Answered);
  const nlohmann::json line = nlohmann::json::parse(out_);
  EXPECT_EQ(line.at("silent"), nlohmann::json({"fcl"}));
  EXPECT_EQ(line.at("testimonies").at(1).at("answer").at("hits").at(0).at("distance"), 2);
}

TEST_F(CliReplay, OneIsNoPlural) {
  const Triangle a{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Triangle b{{1, 1, -1}, {1, 1, 1}, {1, 2, 1}};
  const auto mesh = [](const Triangle& t) {
    return Mesh(std::vector<Eigen::Vector3d>{t.a, t.b, t.c},
                std::vector<TriangleIndices>{{0, 1, 2}});
  };
  Case query =
      to_case(CaseMesh(mesh(a), Pose::Identity()), CaseMesh(mesh(b), Pose::Identity()), true);
  query.ask = Ask::Pairs;
  query.answer.reset();
  directory_.write("pairs.json", to_json(query));
  EXPECT_EQ(replay({}), ExitCode::Answered);
  EXPECT_NE(out_.find(" 1 pair  "), out_.npos) << out_;
  EXPECT_EQ(out_.find("1 pairs"), out_.npos) << out_;
}

TEST_F(CliReplay, OneBadFileStopsNoOther) {
  write_any("b.json", 1.5, true, "graze");
  directory_.write("a.json", "{");
  directory_.write("c.json", "{\"graze_case\": 2}");
  EXPECT_EQ(replay({}), ExitCode::BadInput);
  expect_summary("1 case, graze wrong in 0, changed in 0");
  const std::size_t first = err_.find("a.json:1: not JSON");
  const std::size_t second = err_.find("c.json:1: /graze_case: is version 2");
  EXPECT_LT(first, second) << err_;
  EXPECT_NE(second, err_.npos) << err_;
}

TEST_F(CliReplay, WhereNothingCanBeReadNothingIsPrinted) {
  directory_.write("a.json", "{");
  Output output(stdout);
  EXPECT_THROW(run_replay({.files = {directory_.path("a.json")}}, only_graze(), output), CaseError);
  directory_.write("b.json", "{");
  EXPECT_EQ(replay({}), ExitCode::BadInput);
  EXPECT_EQ(out_, "");
}

/// graze is right about all three, and the two engines that once answered are not.
class CliReplayFailOn : public CliReplay {
 protected:
  CliReplayFailOn() {
    write_any("far.json", 3, true, "fcl");      // a metre of air
    write_any("deep.json", 1.5, false, "ode");  // half a metre deep
    write_any("kiss.json", 2, false, "ode");
    write_any("right.json", 3, false, "bullet");
  }

  ExitCode fail_on(const std::vector<std::string>& words) {
    return replay({.fail_on = words}, engines_);
  }

  std::string refusal_of(const std::string& word) {
    Output output(stdout);
    try {
      run_replay({.files = {directory_.path().string()}, .fail_on = {word}}, engines_, output);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  }

  std::vector<EngineEntry> engines_ = only_graze();
};

TEST_F(CliReplayFailOn, OnlyGrazeFailsByItself) {
  EXPECT_EQ(fail_on({}), ExitCode::Answered);
  expect_summary("4 cases, graze wrong in 0, changed in 0");
  EXPECT_EQ(fail_on({"graze"}), ExitCode::Answered);
  expect_summary("4 cases, graze wrong in 0, changed in 0, 0 wrong answers of --fail-on");
}

TEST_F(CliReplayFailOn, RecordedAnswersCountUnderTheNameOfTheirEngine) {
  EXPECT_EQ(fail_on({"fcl"}), ExitCode::Failed);
  expect_summary("4 cases, graze wrong in 0, changed in 0, 1 wrong answer of --fail-on");
  EXPECT_EQ(fail_on({"ode"}), ExitCode::Failed);
  expect_summary("4 cases, graze wrong in 0, changed in 0, 2 wrong answers of --fail-on");
  EXPECT_EQ(fail_on({"bullet"}), ExitCode::Answered) << "it is right";
  EXPECT_EQ(fail_on({"bullet", "fcl"}), ExitCode::Failed);
  EXPECT_EQ(fail_on({"recorded"}), ExitCode::Failed);
  expect_summary("4 cases, graze wrong in 0, changed in 0, 3 wrong answers of --fail-on");
}

TEST_F(CliReplayFailOn, AClassIsAllThatCounts) {
  EXPECT_EQ(fail_on({"fcl:real"}), ExitCode::Failed);
  EXPECT_EQ(fail_on({"fcl:touching"}), ExitCode::Answered);
  EXPECT_EQ(fail_on({"fcl:pose-rounding", "fcl:pose rounding"}), ExitCode::Answered);
  EXPECT_EQ(fail_on({"ode:touching"}), ExitCode::Answered);
  EXPECT_EQ(fail_on({"ode:coplanar"}), ExitCode::Failed);
  expect_summary("4 cases, graze wrong in 0, changed in 0, 1 wrong answer of --fail-on");
  EXPECT_EQ(fail_on({"recorded:engine-error"}), ExitCode::Answered);
}

TEST_F(CliReplayFailOn, EnginesThatAreAskedCountToo) {
  engines_.push_back({"coal", compare::make_wrong_sign_engine("coal")});
  EXPECT_EQ(fail_on({"coal:containment"}), ExitCode::Answered);
  EXPECT_EQ(replay({.files = {}, .is_json = true, .fail_on = {"recorded:real"}}, engines_),
            ExitCode::Failed);
  std::size_t failures = 0;
  std::istringstream lines(out_);
  for (std::string line; std::getline(lines, line);) {
    const nlohmann::json testimonies = nlohmann::json::parse(line).at("testimonies");
    for (const nlohmann::json& each : testimonies) {
      if (!each.contains("fails")) continue;
      ++failures;
      EXPECT_EQ(each.at("fails"), true);
      EXPECT_EQ(each.at("recorded"), true);
      EXPECT_EQ(each.at("class"), "real");
    }
  }
  EXPECT_EQ(failures, 2u);
}

TEST_F(CliReplayFailOn, WhatCanNeverFailIsRefused) {
  engines_.push_back({"coal", nullptr});
  EXPECT_EQ(refusal_of("newton"),
            "--fail-on: there is no engine \"newton\", but recorded, graze, bullet, fcl, ode");
  EXPECT_EQ(
      refusal_of("fcl:plain"),
      "--fail-on: there is no class \"plain\", but touching, pose-rounding, coplanar, degenerate, "
      "not-least, containment, real, engine-error");
  EXPECT_EQ(refusal_of("coal"), "--fail-on: coal was not found when this command was built");
  EXPECT_NE(refusal_of(""), "");
  EXPECT_EQ(refusal_of(":real"), refusal_of("")) << "no engine";
  EXPECT_NE(refusal_of("fcl:"), "");
}

TEST_F(CliReplay, JsonHasPlainNumbersThatLoseNothing) {
  write_distance("far.json", 1.0 / 3, "fcl");
  EXPECT_EQ(replay({.is_json = true}), ExitCode::Answered);
  const nlohmann::json line = nlohmann::json::parse(out_);
  const nlohmann::json& recorded = line.at("testimonies").at(0);
  EXPECT_EQ(recorded.at("answer").at("distance").get<double>(), 1.0 / 3);
  EXPECT_TRUE(recorded.at("error").is_number());
  EXPECT_TRUE(recorded.at("ulps").is_number());
  const nlohmann::json& graze = line.at("testimonies").at(1);
  EXPECT_EQ(graze.at("answer").at("distance").get<double>(), 1);
  EXPECT_TRUE(graze.at("answer").at("point_a").at(0).is_number());
}

}  // namespace
}  // namespace graze::cli

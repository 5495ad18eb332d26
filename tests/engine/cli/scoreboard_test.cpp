// `graze scoreboard`: who passes what, counted case by case.

#include <graze/engine/cases/write_case.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/replay/case_list.h>
#include <graze/engine/cli/scoreboard/hard_case.h>
#include <graze/engine/cli/scoreboard/scoreboard.h>
#include <graze/engine/compare/judge/judge.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/engine/cli/compare/compare_fixture.h"

namespace graze::cli {
namespace {

using nlohmann::json;

class CliScoreboard : public CliCompare {
 protected:
  CliScoreboard() {
    scored_.is_json = true;
    scored_.files = {directory_.path("hard")};
  }

  static Case box_at(double x, Ask ask) {
    Pose pose = Pose::Identity();
    pose.translation() << x, 0.125, 0.0625;
    return {.note = "",
            .ask = ask,
            .settings = {},
            .a = CaseMesh(tests::make_box({0.5, 0.5, 0.5}), Pose::Identity()),
            .b = CaseMesh(tests::make_box({0.5, 0.5, 0.5}), pose),
            .answer = std::nullopt,
            .answered_by = {}};
  }

  void write(const std::string& kind, const std::vector<Case>& cases) {
    std::string lines;
    for (const Case& each : cases) {
      for (const char c : to_json(each))
        if (c != '\n') lines += c;
      lines += '\n';
    }
    std::filesystem::create_directories(directory_.path("hard"));
    directory_.write("hard/" + kind + ".jsonl", lines);
  }

  ExitCode score(const std::vector<EngineEntry>& engines) {
    return run([&](Output& output) { return run_scoreboard(scored_, engines, output); });
  }

  ScoreboardOptions scored_;
};

/// The double moves B the wrong way along x: right where both ways say the same.
TEST_F(CliScoreboard, CountsWhoPassesWhat) {
  // The meshes are centred, so that the wrong way of the first is as right as the right one.
  write("any", {box_at(0.25, Ask::Any), box_at(2, Ask::Any)});
  write("contains", {Case{.note = "",
                          .ask = Ask::Contains,
                          .settings = {},
                          .a = CaseMesh(tests::make_box({0.5, 0.5, 0.5}), Pose::Identity()),
                          .b = CasePoint{{0.25, 0.25, 0.25}},
                          .answer = std::nullopt,
                          .answered_by = {}}});
  EXPECT_EQ(score(with_wrong_fcl()), ExitCode::Answered);
  const json board = json::parse(out_);
  ASSERT_EQ(board["engines"].size(), 2u);
  const json& graze = board["engines"][0];
  EXPECT_EQ(graze["engine"], "graze");
  EXPECT_EQ(graze["all"]["passed"], 3);
  EXPECT_EQ(graze["classes"]["any"]["passed"], 2);
  const json& fcl = board["engines"][1];
  EXPECT_EQ(fcl["classes"]["any"]["passed"], 2);
  EXPECT_EQ(fcl["classes"]["contains"]["refused"], 1);
  EXPECT_EQ(fcl["all"]["failed"], 0);
}

TEST_F(CliScoreboard, WrongOnesFail) {
  Case off = box_at(1.25, Ask::Any);
  Pose pose = Pose::Identity();
  pose.translation() << 0.5, 0, 0;
  std::get<CaseMesh>(off.a).pose = pose;  // 0.75 apart, and by the wrong way 1.75
  write("any", {off});
  EXPECT_EQ(score(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_EQ(json::parse(out_)["engines"][1]["all"]["failed"], 1) << out_;
  scored_.is_json = false;
  scored_.markdown = directory_.path("table.md");
  score(with_wrong_fcl());
  EXPECT_NE(out_.find("absent: not found"), out_.npos) << out_;
  EXPECT_NE(out_.find("0, 1 failed"), out_.npos) << out_;
  EXPECT_NE(read("table.md").find("| any | 1 | 0, 1 failed |"), std::string::npos)
      << read("table.md");
}

TEST_F(CliScoreboard, WhatCannotBeReadIsRefusedBeforeAnything) {
  write("any", {box_at(0.25, Ask::Any)});
  directory_.write("hard/odd.jsonl", "{}\n");
  EXPECT_THROW(score(with_wrong_fcl()), CaseError);
  EXPECT_EQ(out_, "");
  scored_.engines = "absent";
  EXPECT_THROW(score(with_wrong_fcl()), UsageError);
}

/// A folder of hard cases, and a case that another engine was wrong about.
class CliHardCase : public CliScoreboard {
 protected:
  CliHardCase() {
    write("any", {with_words(box_at(0.25, Ask::Any), "deep", true)});
    directory_.write("hard/README.md", kPage);
    write_case(directory_.path("odd.json"), with_words(box_at(2, Ask::Any), "apart", true));
  }

  static constexpr const char* kPage =
      "# Hard\n\n| file | cases | what |\n|---|---|---|\n| `any.jsonl` | 7 | yes or no |\n"
      "| `new.jsonl` | 0 | more |\n";

  static Case with_words(Case query, const char* note, bool says) {
    query.note = note;
    query.origin = "made by hand";
    query.answer.emplace().says = says;
    query.answered_by = {"other", "1"};
    return query;
  }

  HardCaseOptions options(const std::string& kind) const {
    return {.folder = directory_.path("hard"),
            .file = directory_.path("odd.json"),
            .kind = kind,
            .origin = "",
            .note = ""};
  }

  void add(const HardCaseOptions& options) {
    run([&](Output& output) {
      add_hard_case(options, output);
      return ExitCode::Answered;
    });
  }

  std::string refusal(const HardCaseOptions& options) {
    try {
      add(options);
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  }
};

TEST_F(CliHardCase, JoinsItsClassWithItsTruthAndIsCounted) {
  add(options("any"));
  EXPECT_NE(out_.find("any.jsonl: has 2 cases"), out_.npos) << out_;
  const std::string page = read("hard/README.md");
  EXPECT_NE(page.find("| `any.jsonl` | 2 | yes or no |"), page.npos) << page;
  EXPECT_NE(page.find("| `new.jsonl` | 0 | more |"), page.npos) << "no such file: left as it is";
  const std::string lines = read("hard/any.jsonl");
  const std::string line = lines.substr(lines.find('\n') + 1);
  EXPECT_EQ(line.find("0x"), line.npos) << "plain numbers alone";
  EXPECT_EQ(line.find("{\"graze_case\": 1, \"note\": \"apart\", "), 0u) << line;
  read_listed_cases(
      directory_.path("hard/any.jsonl"), {},
      [&](const ListedCase& each) {
        if (each.query.note != "apart") return;
        EXPECT_EQ(each.query.answer->says, false) << "the engine was wrong";
        EXPECT_EQ(each.query.answered_by.engine, "graze");
        EXPECT_EQ(each.query.origin, "made by hand");
      },
      [](const Error& error) { ADD_FAILURE() << error.what(); });
  EXPECT_EQ(with_counts(page, directory_.path("hard")), page);
  HardCaseOptions other = options("new");
  other.note = "the same, by another note";
  EXPECT_NE(refusal(other).find("any.jsonl:2 asks the same"), std::string::npos) << refusal(other);
}

TEST_F(CliHardCase, WhatDoesNotFitIsRefusedAndNothingIsWritten) {
  const std::string before = read("hard/any.jsonl");
  for (const char* kind : {"", "../any", "Any", "a b"})
    EXPECT_EQ(refusal(options(kind)).find("--class: "), 0u) << kind;
  Case bare = with_words(box_at(2, Ask::Any), "apart", true);
  bare.origin.clear();
  write_case(directory_.path("odd.json"), bare);
  EXPECT_EQ(refusal(options("any")), "--add needs --origin: where the case is from");
  bare.origin = "here";
  bare.note.clear();
  write_case(directory_.path("odd.json"), bare);
  EXPECT_EQ(refusal(options("any")), "--add needs --note: what is hard about the case");
  bare.note = "deep";
  write_case(directory_.path("odd.json"), bare);
  EXPECT_NE(refusal(options("any")).find("any.jsonl:1 has this note"), std::string::npos);
  bare.ask = Ask::SelfAny;
  bare.b.reset();
  write_case(directory_.path("odd.json"), bare);
  EXPECT_NE(refusal(options("any")).find("proves no answer"), std::string::npos);
  EXPECT_EQ(read("hard/any.jsonl"), before);
  EXPECT_EQ(read("hard/README.md"), kPage);
}

/// The page of the folder and the folder cannot part: counts, and a row for each file.
TEST(HardCases, AreCountedOnTheirPage) {
  const std::string folder = std::string(GRAZE_DATA_DIR) + "/hard_cases";
  std::ifstream file(folder + "/README.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(with_counts(page, folder), page) << "graze scoreboard --add counts them";
  for (const std::filesystem::path& each : case_files({folder})) {
    const std::string row = "| `" + each.filename().string() + "` | ";
    EXPECT_NE(page.find(row), page.npos) << each;
  }
}

/// Each has its truth, which the referee finds wholly right, and says where it is from.
TEST(HardCases, AreTrueAndSayWhereTheyAreFrom) {
  std::set<std::string> notes;
  std::size_t public_ones = 0;
  for (const std::filesystem::path& file :
       case_files({std::string(GRAZE_DATA_DIR) + "/hard_cases"})) {
    read_listed_cases(
        file, {},
        [&](const ListedCase& each) {
          SCOPED_TRACE(each.name);
          const Case& query = each.query;
          EXPECT_FALSE(query.origin.empty());
          public_ones += query.origin.find("https://") != std::string::npos;
          EXPECT_TRUE(notes.insert(query.note).second) << "twice: " << query.note;
          ASSERT_TRUE(query.answer);
          const compare::Judgement judgement =
              compare::Judge(query).judge(*query.answer, query.answered_by);
          EXPECT_EQ(judgement.verdict, compare::Verdict::Right) << judgement.truth;
        },
        [](const Error& error) { ADD_FAILURE() << error.what(); });
  }
  EXPECT_GT(notes.size(), 120u);
  EXPECT_GT(public_ones, 20u);
}

}  // namespace
}  // namespace graze::cli

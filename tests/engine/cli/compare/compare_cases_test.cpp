// The cases that `graze compare` writes: their names, and folders that refuse them.

#include <graze/engine/cases/read_case.h>
#include <graze/engine/cli/files/case_folder.h>
#include <graze/engine/cli/output/outcome.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/engine/cli/compare/compare_fixture.h"

namespace graze::cli {
namespace {

namespace fs = std::filesystem;

class CliCompareCases : public CliCompare {
 protected:
  CliCompareCases() {
    options_.query = "pairs";
    options_.keep = 100;
    options_.threads = 1;
  }

  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const fs::path& file : found())
      all.insert(file.filename().string());
    return all;
  }

  std::size_t rows(const std::string& start) const {
    std::size_t count = 0;
    std::istringstream lines(out_);
    for (std::string line; std::getline(lines, line);)
      count += line.starts_with(start);
    return count;
  }

  /// What a run says on stderr.
  std::string said_by(ExitCode expected) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(compare(with_wrong_fcl()), expected);
    return testing::internal::GetCapturedStderr();
  }
};

TEST_F(CliCompareCases, NamesSayWhatTheyAreAboutAndNoTwoAreTheSame) {
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  const std::set<std::string> first = names();
  EXPECT_GT(first.size(), 1u);
  EXPECT_EQ(rows("shrunk: "), first.size());
  EXPECT_EQ(out_.find("of other runs"), out_.npos) << out_;
  for (const std::string& name : first)
    EXPECT_TRUE(name.starts_with("a-b-fcl-pairs-pose")) << name;

  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered) << "the same again";
  EXPECT_EQ(names(), first);
  EXPECT_EQ(out_.find("of other runs"), out_.npos) << out_;

  options_.seed = 2;  // other poses of the same numbers
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  const std::size_t second = rows("shrunk: ");
  EXPECT_EQ(names().size(), first.size() + second);
  EXPECT_NE(out_.find(options_.cases + " also holds " + std::to_string(first.size()) +
                      " cases of other runs\n"),
            out_.npos)
      << out_;

  options_.query = "any";
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  const std::size_t third = rows("shrunk: ");
  directory_.write("b.off",
                   off_of(tests::make_box({0.5, 0.5, 0.75})));  // the name alone is the same
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  EXPECT_EQ(names().size(), first.size() + second + third + rows("shrunk: "));
}

TEST(CliCaseNames, AreNamesOfFilesWhateverTheyAreMadeOf) {
  const Triangle t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Case query{.note = "",
                   .ask = Ask::Any,
                   .settings = {},
                   .a = t,
                   .b = t,
                   .answer = std::nullopt,
                   .answered_by = {"fcl", "1"}};
  EXPECT_EQ(name_part("bolt-1/\n\xff ../x"), "bolt_1____.._x");
  EXPECT_EQ(name_part(std::string(300, 'x')).size(), 40u);
  const std::string name = case_file_name("bolt", "pose rounding", query);
  EXPECT_TRUE(name.starts_with("bolt-pose_rounding-")) << name;
  Case other = query;
  other.note = "a note changes no question";
  EXPECT_EQ(case_file_name("bolt", "pose rounding", other), name);
  other.answered_by.version = "2";
  EXPECT_NE(case_file_name("bolt", "pose rounding", other), name);
  other = query;
  other.b = Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0x1p-1074}};
  EXPECT_NE(case_file_name("bolt", "pose rounding", other), name) << "one bit";
}

TEST_F(CliCompareCases, AFolderThatRefusesThemStopsNothing) {
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  const std::size_t count = rows("shrunk: ");
  const std::string table = out_.substr(0, out_.find("shrunk: "));
  options_.cases = directory_.path("b.off/cases");  // no permission is needed to be refused here
  options_.report = directory_.path("report.html");
  const std::string said = said_by(ExitCode::BadInput);
  EXPECT_TRUE(said.starts_with("graze: " + std::to_string(count) +
                               " cases not written: " + options_.cases + ": "))
      << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  EXPECT_EQ(rows("shrunk, not written: "), count);
  EXPECT_EQ(out_.substr(0, out_.find("shrunk, ")), table);
  EXPECT_NE(read("report.html").find("It could not be written."), std::string::npos);
  options_.is_json = true;
  said_by(ExitCode::BadInput);
  const std::string last = out_.substr(out_.rfind('\n', out_.size() - 2) + 1);
  const nlohmann::json cases = nlohmann::json::parse(last).at("cases");
  ASSERT_EQ(cases.size(), count);
  for (const nlohmann::json& each : cases)
    EXPECT_EQ(each.at("written"), false);
}

/// Nobody asked for the folder: its absence is told, and the answer stays an answer.
TEST_F(CliCompareCases, TheDefaultFolderIsNoCondition) {
  const fs::path before = fs::current_path();
  fs::current_path(directory_.path());
  options_.cases.clear();
  directory_.write(kDefaultCases, "a file in its place");
  const std::string said = said_by(ExitCode::Answered);
  EXPECT_NE(said.find(" not written: graze-cases: "), std::string::npos) << said;
  EXPECT_EQ(read(kDefaultCases), "a file in its place");
  fs::remove(kDefaultCases);
  EXPECT_EQ(said_by(ExitCode::Answered), "");
  EXPECT_GT(case_files({kDefaultCases}).size(), 1u);
  fs::current_path(before);
  options_.cases = directory_.path("b.off");
  EXPECT_THROW(compare(with_wrong_fcl()), UsageError) << "asked for, and no folder";
}

TEST_F(CliCompareCases, WithoutTimeTheyAreWrittenAsTheyWereFound) {
  options_.shrink_seconds = 0;
  EXPECT_EQ(compare(with_wrong_fcl()), ExitCode::Answered);
  ASSERT_GT(found().size(), 1u);
  EXPECT_EQ(rows("shrunk: graze replay "), found().size());
  EXPECT_NE(out_.find(" (the time was over: see --shrink-seconds)\n"), out_.npos) << out_;
  for (const fs::path& file : found()) {
    const Case query = read_case(file);
    EXPECT_EQ(compare::as_meshes(query)->a.mesh.triangles().size(), 160u);
    ASSERT_TRUE(query.answer && query.answer->pairs);
  }
  const ExitCode code = run([&](Output& output) {
    return run_replay({.files = {options_.cases}, .fail_on = {"recorded:real"}}, with_wrong_fcl(),
                      output);
  });
  EXPECT_EQ(code, ExitCode::Failed) << "each shows what it is about";
}

}  // namespace
}  // namespace graze::cli

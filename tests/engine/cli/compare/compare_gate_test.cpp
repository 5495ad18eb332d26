// What makes `graze compare` fail, and what it writes for code hosts.

#include <graze/engine/cli/compare/engine_field.h>
#include <graze/engine/cli/output/outcome.h>
#include <gtest/gtest.h>

#include "tests/engine/cli/compare/compare_fixture.h"

namespace graze::cli {
namespace {

class CliCompareGate : public CliCompare {
 protected:
  CliCompareGate() { options_.random = 24; }
  ExitCode gated(std::vector<std::string> fail_on) {
    options_.fail_on = std::move(fail_on);
    return compare(with_wrong_fcl());
  }
};

TEST_F(CliCompareGate, OpensForOthersErrorsUntilTheyAreNamed) {
  EXPECT_EQ(gated({}), ExitCode::Answered);
  EXPECT_EQ(out_.find("--fail-on"), out_.npos);
  EXPECT_EQ(gated({"fcl"}), ExitCode::Failed);
  EXPECT_NE(out_.find(" of --fail-on\n"), out_.npos) << out_;
  EXPECT_EQ(gated({"graze"}), ExitCode::Answered);
  EXPECT_NE(out_.find("0 wrong answers of --fail-on\n"), out_.npos) << out_;
}

TEST_F(CliCompareGate, LooksAtClassesAndSizes) {
  EXPECT_EQ(gated({"fcl:real"}), ExitCode::Failed);
  EXPECT_EQ(gated({"fcl:engine-error"}), ExitCode::Answered);
  EXPECT_EQ(gated({"fcl:engine-error", "fcl:real"}), ExitCode::Failed);
  EXPECT_EQ(gated({"fcl>1e-9"}), ExitCode::Failed);
  EXPECT_EQ(gated({"fcl:real>0"}), ExitCode::Failed);
  EXPECT_EQ(gated({"fcl:real>100"}), ExitCode::Answered) << "no error here is as large";
}

TEST_F(CliCompareGate, CountsInJson) {
  options_.is_json = true;
  EXPECT_EQ(gated({"fcl"}), ExitCode::Failed);
  EXPECT_NE(out_.find("\n{\"fail_on\":"), out_.npos) << out_;
  EXPECT_EQ(out_.find("{\"fail_on\":0}"), out_.npos);
}

TEST_F(CliCompareGate, RefusesWhatItCannotMeanBeforeAnythingIsAsked) {
  for (const char* word : {"nobody", "fcl:odd", "fcl>much", "fcl>-1", "fcl>", "fcl>inf", "absent"})
    EXPECT_THROW(gated({word}), UsageError) << word;
  EXPECT_TRUE(found().empty());
}

TEST_F(CliCompareGate, WritesWhatRunnersOfTestsRead) {
  options_.junit = directory_.path("out.xml");
  EXPECT_EQ(gated({}), ExitCode::Answered);
  EXPECT_NE(read("out.xml").find("tests=\"2\" failures=\"0\""), std::string::npos);
  EXPECT_EQ(gated({"fcl:real"}), ExitCode::Failed);
  const std::string xml = read("out.xml");
  EXPECT_EQ(xml.rfind("<?xml version=\"1.0\"", 0), 0u);
  EXPECT_NE(xml.find("tests=\"2\" failures=\"1\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("name=\"graze\" time="), std::string::npos);
  EXPECT_NE(xml.find("<failure message=\""), std::string::npos);
  EXPECT_NE(xml.find("the truth is: "), std::string::npos) << xml;
}

TEST_F(CliCompareGate, WritesATableForCodeHosts) {
  options_.markdown = directory_.path("out.md");
  EXPECT_EQ(gated({}), ExitCode::Answered);
  EXPECT_NE(read("out.md").find("**passed**"), std::string::npos);
  EXPECT_EQ(gated({"fcl"}), ExitCode::Failed);
  const std::string page = read("out.md");
  EXPECT_NE(page.find("**failed**"), std::string::npos);
  EXPECT_NE(page.find("\n| fcl | 24 |"), std::string::npos) << page;
}

TEST_F(CliCompareGate, GivesAdviceInEveryForm) {
  options_.markdown = directory_.path("out.md");
  options_.report = directory_.path("out.html");
  EXPECT_EQ(gated({}), ExitCode::Answered);
  EXPECT_NE(out_.find("what to do:\n  fcl, "), out_.npos) << out_;
  EXPECT_NE(out_.find("no rounding of the input explains it"), out_.npos) << out_;
  for (const char* file : {"out.md", "out.html"}) {
    const std::string page = read(file);
    EXPECT_NE(page.find("<summary>The text of an issue</summary>"), page.npos) << page;
    EXPECT_NE(page.find("graze replay "), page.npos);
    EXPECT_NE(page.find("\n- Got: "), page.npos) << "line by line";
  }
  options_.is_json = true;
  EXPECT_EQ(gated({}), ExitCode::Answered);
  const std::size_t at = out_.find("{\"advice\":[{\"engine\":\"fcl\",\"class\":\"real\"");
  ASSERT_NE(at, out_.npos) << out_;
  EXPECT_NE(out_.find("\"remedy\":\"report\"", at), out_.npos);
  EXPECT_NE(out_.find("\"issue\":\"# Wrong answer: ", at), out_.npos);
}

TEST_F(CliCompareGate, FilesMayNotBeInputs) {
  options_.junit = options_.mesh_a;
  EXPECT_THROW(gated({}), UsageError);
}

std::string refusal(const std::vector<std::string>& commands) {
  try {
    engines_with({.timeout = std::chrono::duration<double>(20)}, commands);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "none";
}

std::string hello(const std::string& name) {
  return "echo '{\"graze_peer\":1,\"engine\":\"" + name + "\"}'";
}

TEST(CliEngineCommand, TakesNamesThatAreFree) {
  EXPECT_EQ(refusal({hello("mine"), hello("yours")}), "none");
  EXPECT_NE(refusal({hello("fcl")}).find("as another engine does"), std::string::npos);
  EXPECT_NE(refusal({hello("graze")}).find("as another engine does"), std::string::npos);
  EXPECT_NE(refusal({hello("recorded")}).find("as another engine does"), std::string::npos);
  EXPECT_NE(refusal({hello("mine"), hello("mine")}).find("as another"), std::string::npos);
  EXPECT_NE(refusal({hello("a,b")}).find("could not name"), std::string::npos);
  EXPECT_NE(refusal({hello("")}).find("could not name"), std::string::npos);
  EXPECT_NE(refusal({"exit 4"}).find("exit code 4"), std::string::npos) << refusal({"exit 4"});
}

TEST(CliEngineCommand, TakesPartWhateverOthersDo) {
  const std::vector<EngineEntry> engines = engines_with({}, std::vector{hello("mine")});
  const Field field(engines, "graze");
  ASSERT_EQ(field.engines().size(), 2u);
  EXPECT_EQ(field.engines()[1].name, "mine");
}

}  // namespace
}  // namespace graze::cli

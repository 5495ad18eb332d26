// `graze compare --answers`: what an engine said elsewhere is judged as if it had been asked, and
// every error that is planted in it is counted once.

#include <graze/bvh/error.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/cli/compare/engine_field.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/files/sha256.h>
#include <graze/engine/mesh/load_mesh.h>
#include <gtest/gtest.h>
#include <functional>
#include <nlohmann/json.hpp>

#include "tests/engine/cli/answers_fixture.h"

namespace graze::cli {
namespace {

TEST_F(CliCompareAnswers, HonestOnesAreRight) {
  for (const auto& [query, ask] : {std::pair("any", Ask::Any), std::pair("pairs", Ask::Pairs),
                                   std::pair("distance", Ask::Distance)}) {
    const json summary = judged(query, written(head(query), honest(ask)));
    EXPECT_EQ(summary["answers"], kPoses) << query;
    EXPECT_EQ(summary["wrong"], 0) << query;
    EXPECT_EQ(summary["median_us"], 12.5);
  }
}

TEST_F(CliCompareAnswers, EveryPlantedErrorIsCounted) {
  std::vector<json> lines = honest(Ask::Any);
  lines[3] = {{"answer", "crash"}};
  lines[5] = {{"answer", "timeout"}, {"us", 1e6}};
  lines[7] = {{"answer", "nan"}};
  lines[9] = {{"error", "out of its depth"}};
  lines[11] = {{"unsupported", "no such question"}};
  lines[13]["answer"]["says"] = !lines[13]["answer"]["says"].get<bool>();
  lines[15]["answer"] = {{"distance", 1}};  // of another question
  const json summary = judged("any", written(head("any"), lines));
  EXPECT_EQ(summary["answers"], kPoses - 1) << "a refusal is no answer";
  EXPECT_EQ(summary["wrong"], 6);
  EXPECT_EQ(summary["engine_error"], 5);
  EXPECT_EQ(summary["real"], 1);
  EXPECT_EQ(summary["not_confirmed"], 0) << "nothing can be asked again";
}

/// A case for each, as of engines that are asked, with the meshes in files beside them.
TEST_F(CliCompareAnswers, WrongOnesAreKeptAsCases) {
  std::vector<json> lines = honest(Ask::Distance);
  lines[30]["answer"]["distance"] = lines[30]["answer"]["distance"].get<double>() + 0.5;
  options_.keep = 4;
  options_.query = "distance";
  options_.answers = {written(head("distance"), lines)};
  EXPECT_EQ(compare(graze_alone()), ExitCode::Answered) << out_;
  ASSERT_EQ(found().size(), 1u) << out_;
  const Case kept = read_case(found().front());
  EXPECT_EQ(kept.answered_by.engine, "other");
  EXPECT_EQ(kept.answered_by.version, "1");
  EXPECT_EQ(*kept.answer->distance, lines[30]["answer"]["distance"].get<double>());
  const auto& mesh = std::get<CaseMesh>(kept.a);
  ASSERT_TRUE(mesh.file.has_value());
  EXPECT_EQ(mesh.mesh.triangles().size(), load_mesh(options_.mesh_a).triangles().size());
  EXPECT_EQ(std::get<CaseMesh>(*kept.b).pose.matrix(), poses_[30].matrix());
  const ExitCode code = run([&](Output& output) {
    return run_replay({.files = {options_.cases}, .is_json = true}, graze_alone(), output);
  });
  EXPECT_EQ(code, ExitCode::Answered);
  EXPECT_NE(out_.find("\"recorded\":true"), out_.npos);
  EXPECT_NE(out_.find("\"verdict\":\"wrong\",\"truth\""), out_.npos) << out_;
}

TEST_F(CliCompareAnswers, OneMissedPairIsFound) {
  std::vector<json> lines = honest(Ask::Pairs);
  std::size_t planted = 0;
  for (std::size_t i = 0; i < lines.size() && planted < 3; ++i) {
    json& pairs = lines[i]["answer"]["pairs"];
    if (pairs.size() < 2) continue;
    pairs.erase(pairs.begin());
    ++planted;
  }
  ASSERT_EQ(planted, 3u);
  EXPECT_EQ(judged("pairs", written(head("pairs"), lines))["wrong"], 3);
}

/// A picometre is far beyond what rounding makes of a torus of a metre.
TEST_F(CliCompareAnswers, APicometreInADistanceIsFound) {
  std::vector<json> lines = honest(Ask::Distance);
  int planted = 0;
  for (json& line : lines) {
    json& distance = line["answer"]["distance"];
    if (distance.get<double>() == 0 || planted == 2) continue;
    distance = distance.get<double>() + 1e-12;
    ++planted;
  }
  ASSERT_EQ(planted, 2);
  const json summary = judged("distance", written(head("distance"), lines));
  EXPECT_EQ(summary["wrong"], 2);
  EXPECT_NEAR(summary["largest_error"].get<double>(), 1e-12, 1e-15);
  lines[0]["answer"]["distance"] = "nan";
  EXPECT_EQ(judged("distance", written(head("distance"), lines))["engine_error"], 1);
}

/// Of two boxes, whose contacts can be judged.
TEST_F(CliCompareAnswers, AReversedNormalIsFound) {
  directory_.write("a.off", off_of(tests::make_box({0.5, 0.5, 0.5})));
  std::vector<json> lines = honest(Ask::Contacts);
  EXPECT_EQ(judged("contacts", written(head("contacts"), lines))["wrong"], 0);
  int planted = 0;
  for (json& line : lines) {
    for (json& contact : line["answer"]["contacts"]) {
      for (json& x : contact["normal"])
        x = -x.get<double>();
      ++planted;
      break;
    }
    if (planted == 1) break;
  }
  ASSERT_EQ(planted, 1);
  EXPECT_EQ(judged("contacts", written(head("contacts"), lines))["wrong"], 1) << out_;
}

TEST_F(CliCompareAnswers, TablesAreReadToo) {
  std::string text = "# " + head("distance").dump() + "\npose, distance, us\n";
  const std::vector<json> lines = honest(Ask::Distance);
  for (int i = 0; i < kPoses; ++i) {
    const std::string distance =
        i == 4   ? "nan"
        : i == 6 ? "crash"
                 : lines[static_cast<std::size_t>(i)]["answer"]["distance"].dump();
    text += std::to_string(i) + "," + distance + ",3.5\r\n";
  }
  const json summary = judged("distance", directory_.write("answers.csv", text));
  EXPECT_EQ(summary["answers"], kPoses);
  EXPECT_EQ(summary["wrong"], 2);
  EXPECT_EQ(summary["engine_error"], 2);
  EXPECT_EQ(summary["median_us"], 3.5);
}

TEST_F(CliCompareAnswers, WhatIsOfSomethingElseIsRefused) {
  const std::vector<json> lines = honest(Ask::Any);
  const std::string file = directory_.path("answers.jsonl");
  json other = head("any");
  other["mesh_b"]["sha256"] = std::string(64, '0');
  EXPECT_EQ(refusal("any", written(other, lines)),
            file + ":1:1: /mesh_b/sha256: is not that of " + options_.mesh_b);
  EXPECT_NE(refusal("pairs", written(head("any"), lines)).find(":1:1: /question: "),
            std::string::npos);
  other = head("any");
  other["poses"] = 7;
  EXPECT_NE(refusal("any", written(other, lines)).find(":1:1: /poses: is not 40"),
            std::string::npos);
  std::vector<json> fewer(lines.begin(), lines.end() - 1);
  EXPECT_EQ(refusal("any", written(head("any"), fewer)), file + ":41: ends after 39 answers of 40");
  std::vector<json> more = lines;
  more.push_back(lines[0]);
  EXPECT_EQ(refusal("any", written(head("any"), more)),
            file + ":42: one more than the 40 that are asked for");
  more = lines;
  more[8]["pose"] = 9;
  EXPECT_NE(refusal("any", written(head("any"), more)).find(":10:1: /pose: is not 8"),
            std::string::npos);
  EXPECT_EQ(refusal("any", directory_.path("nowhere")),
            directory_.path("nowhere") + ": cannot be read");
}

TEST_F(CliCompareAnswers, LinesThatCannotBeReadAreNamed) {
  const std::string good = head("any").dump() + "\n{\"answer\":{\"says\":true}}\n";
  for (const char* line :
       {"", "[", "{}", "7", "{\"answer\":\"maybe\"}", "{\"answer\":7}",
        "{\"answer\":{\"says\":true},\"error\":\"x\"}", "{\"says\":true}",
        "{\"answer\":{\"distance\":NaN}}", "{\"answer\":{\"says\":true},\"us\":\"x\"}", "\xff\xfe",
        "{\"answer\":{\"says\":true},\"pose\":-1}"}) {
    const std::string file = directory_.write("answers.jsonl", good + line + "\n");
    EXPECT_EQ(refusal("any", file).find(file + ":3"), 0u) << line << ": " << refusal("any", file);
  }
  for (const char* start : {"", "{}", "[]", "{\"graze_answers\":2}", "{\"graze_answers\":1}"}) {
    const std::string file = directory_.write("answers.jsonl", std::string(start) + "\n");
    EXPECT_EQ(refusal("any", file).find(file + ":1"), 0u) << start << ": " << refusal("any", file);
  }
  const std::string table = "#" + head("any").dump() + "\n";
  for (const char* rest : {"", "says,says\n", "pairs\n", "says\ntrue,false\n", "says\nperhaps\n",
                           "says,us\ntrue,x\n", "says\n\n\n"}) {
    const std::string file = directory_.write("answers.csv", table + rest);
    EXPECT_EQ(refusal("any", file).find(file + ":"), 0u) << rest << ": " << refusal("any", file);
  }
}

TEST_F(CliCompareAnswers, TwoVersionsOfOneEngineStandBesideEachOther) {
  std::vector<json> lines = honest(Ask::Any);
  const std::string before = written(head("any"), lines, "before.jsonl");
  lines[2]["answer"]["says"] = !lines[2]["answer"]["says"].get<bool>();
  json newer = head("any");
  newer["version"] = "2";
  options_.answers = {before, written(newer, lines, "after.jsonl")};
  EXPECT_EQ(compare(graze_alone()), ExitCode::Answered);
  EXPECT_EQ(summary_of("other")["wrong"], 0);
  EXPECT_EQ(summary_of("other@2")["wrong"], 1);
  options_.answers.push_back(before);
  options_.answers.push_back(before);
  EXPECT_THROW(compare(graze_alone()), UsageError);
}

TEST_F(CliCompareAnswers, AreHeldAgainstWhatTheyWere) {
  std::vector<json> lines = honest(Ask::Any);
  options_.save = directory_.path("base");
  judged("any", written(head("any"), lines));
  options_.save.clear();
  options_.against = directory_.path("base");
  options_.time_tolerance = 1e9;
  lines[2]["answer"]["says"] = !lines[2]["answer"]["says"].get<bool>();
  lines[4] = {{"answer", "crash"}};
  judged("any", written(head("any"), lines));
  const std::size_t at = out_.find("{\"against\"");
  const json against = json::parse(out_.substr(at, out_.find('\n', at) - at))["against"];
  const json& other = against["engines"][1];
  EXPECT_EQ(other["engine"], "other");
  EXPECT_EQ(other["changed"], 1);
  EXPECT_EQ(other["first_changed"], json({2}));
  EXPECT_EQ(other["right_to_wrong"], 1);
  EXPECT_EQ(other["missing"], 1) << "a crash";
}

TEST_F(CliCompareAnswers, ARunGoesOnWithTheSameAnswersAlone) {
  std::vector<json> lines = honest(Ask::Any);
  options_.resume = directory_.path("run");
  judged("any", written(head("any"), lines));
  lines[0]["us"] = 13;
  EXPECT_NE(refusal("any", written(head("any"), lines)).find("other recorded answers"),
            std::string::npos);
}

}  // namespace
}  // namespace graze::cli

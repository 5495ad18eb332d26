// `graze compare` with a wrapper of an engine over the pipe: what is planted in it is found, and
// counted once, whatever is asked; and answers about shapes.

#include <graze/engine/cases/read_case.h>
#include <gtest/gtest.h>
#include <algorithm>

#include "tests/engine/cli/answers_fixture.h"

namespace graze::cli {
namespace {

class CliCompareWrapper : public CliCompareAnswers {
 protected:
  /// What the summary says of a wrapper that looks up what to say by the pose: an answer, or a word
  /// for what it does instead.
  json asked(const std::string& query, const json& said, double timeout = 60) {
    directory_.write("said.json", said.dump());
    const std::string program = directory_.write("engine.py", R"(
import json, os, sys, time
said = json.load(open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "said.json")))
print(json.dumps({"graze_peer": 1, "engine": "other", "version": "1"}), flush=True)
for line in sys.stdin:
    request = json.loads(line)
    if "load" in request:
        print(json.dumps({"id": request["id"], "loaded": True}), flush=True)
        continue
    answer = said[round(request["pose_b"][3] / 0.0625)]
    if answer == "crash":
        os.abort()
    if answer == "hang":
        time.sleep(600)
    if answer == "nonsense":
        print("{", flush=True)
        continue
    print(json.dumps({"id": request["id"], "answer": answer, "us": 1}), flush=True)
)");
    std::vector<EngineEntry> engines = graze_alone();
    engines.push_back(compare::start_engine("exec python3 '" + program + "' 2>/dev/null",
                                            {.timeout = std::chrono::duration<double>(timeout)}));
    options_.query = query;
    EXPECT_EQ(compare(engines), ExitCode::Answered) << out_;
    json summary = summary_of("other");
    EXPECT_EQ(summary["answers"], kPoses);
    EXPECT_EQ(summary["not_confirmed"], 0);
    return summary;
  }

  json answers(Ask ask) const {
    json said = json::array();
    for (const json& line : honest(ask))
      said.push_back(line["answer"]);
    return said;
  }
};

TEST_F(CliCompareWrapper, HonestOnesAreRight) {
  for (const auto& [query, ask] : {std::pair("any", Ask::Any), std::pair("pairs", Ask::Pairs),
                                   std::pair("distance", Ask::Distance)}) {
    EXPECT_EQ(asked(query, answers(ask))["wrong"], 0) << query;
  }
}

TEST_F(CliCompareWrapper, CrashesNonsenseAndWrongAnswersAreCounted) {
  json said = answers(Ask::Any);
  said[3] = "crash";
  said[9] = "nonsense";
  said[13]["says"] = !said[13]["says"].get<bool>();
  said[15] = {{"distance", 1}};
  const json summary = asked("any", said);
  EXPECT_EQ(summary["wrong"], 4);
  EXPECT_EQ(summary["engine_error"], 3);
  EXPECT_EQ(summary["real"], 1);
}

TEST_F(CliCompareWrapper, AHangIsEndedAndCountedOnce) {
  json said = answers(Ask::Any);
  said[20] = "hang";
  const json summary = asked("any", said, 4);
  EXPECT_EQ(summary["wrong"], 1);
  EXPECT_EQ(summary["engine_error"], 1);
  EXPECT_NE(out_.find("gave no answer in 4 s"), out_.npos) << out_;
}

TEST_F(CliCompareWrapper, APicometreAMissedPairAndAReversedNormalAreFound) {
  json said = answers(Ask::Distance);
  const double far = said[35]["distance"].get<double>();
  ASSERT_GT(far, 0);
  said[35]["distance"] = far + 1e-12;
  json summary = asked("distance", said);
  EXPECT_EQ(summary["wrong"], 1);
  EXPECT_NEAR(summary["largest_error"].get<double>(), 1e-12, 1e-15);
  said = answers(Ask::Pairs);
  const auto most = std::max_element(said.begin(), said.end(), [](const json& a, const json& b) {
    return a["pairs"].size() < b["pairs"].size();
  });
  ASSERT_GT((*most)["pairs"].size(), 2u);
  (*most)["pairs"].erase(1);
  EXPECT_EQ(asked("pairs", said)["wrong"], 1);
  directory_.write("a.off", off_of(tests::make_box({0.5, 0.5, 0.5})));
  said = answers(Ask::Contacts);
  const auto touching = std::find_if(said.begin(), said.end(),
                                     [](const json& each) { return !each["contacts"].empty(); });
  ASSERT_NE(touching, said.end());
  for (json& contact : (*touching)["contacts"])
    for (json& x : contact["normal"])
      x = -x.get<double>();
  EXPECT_EQ(asked("contacts", said)["wrong"], 1) << out_;
}

/// Answers about shapes, by file or in the line itself.
TEST_F(CliCompareWrapper, OfShapesAreJudgedLikewise) {
  options_.mesh_a = directory_.write("a.json", R"({"sphere": {"radius": 1}})");
  options_.mesh_b = directory_.write("b.json", R"({"box": {"half_extents": [0.5, 0.5, 0.5]}})");
  const auto start = [&](const std::string& question, bool is_inline) {
    json line = head(question);
    line.erase("mesh_a");
    line.erase("mesh_b");
    line["shape_a"] = is_inline ? json::parse(read("a.json"))
                                : json{{"sha256", files::sha256_of(read("a.json"))}};
    line["shape_b"] = {{"file", "b.json"}, {"sha256", files::sha256_of(read("b.json"))}};
    return line;
  };
  // The box along x, off by a little in y and z: its nearest point is on its face.
  std::vector<json> says;
  std::vector<json> distances;
  for (const Pose& pose : poses_) {
    const double gap = pose(0, 3) - 0.5 - 1;
    says.push_back({{"answer", {{"says", gap <= 0}}}});
    distances.push_back({{"answer", {{"distance", std::max(gap, 0.0)}}}});
  }
  for (const bool is_inline : {false, true}) {
    json summary = judged("any", written(start("any", is_inline), says));
    EXPECT_EQ(summary["answers"], kPoses);
    EXPECT_EQ(summary["wrong"], 0) << out_;
    summary = judged("distance", written(start("distance", is_inline), distances));
    EXPECT_EQ(summary["answers"], kPoses);
    EXPECT_EQ(summary["wrong"], 0) << out_;
  }
  says[38]["answer"]["says"] = true;
  EXPECT_EQ(judged("any", written(start("any", true), says))["real"], 1);
  const double far = distances[38]["answer"]["distance"].get<double>();
  options_.keep = 4;
  for (const double claimed : {0.25, far + 1e-3}) {
    distances[38]["answer"]["distance"] = claimed;
    const json summary = judged("distance", written(start("distance", true), distances));
    EXPECT_EQ(summary["wrong"], 1) << claimed << out_;
    EXPECT_NEAR(summary["largest_error"].get<double>(), std::abs(claimed - far), 1e-8);
    EXPECT_EQ(summary["not_judged"], 0);
  }
  ASSERT_EQ(found().size(), 1u);
  EXPECT_EQ(*read_case(found().front()).answer->distance, far + 1e-3);
  json other = start("any", true);
  other["shape_a"]["sphere"]["radius"] = 2;
  EXPECT_NE(refusal("any", written(other, says)).find("/shape_a: is not "), std::string::npos);
  EXPECT_NE(refusal("any", written(head("any"), says)).find("/mesh_a/sha256: is not that of "),
            std::string::npos);
  EXPECT_THROW(judged("pairs", written(start("pairs", true), says)), UsageError);
}

}  // namespace
}  // namespace graze::cli

// `graze compare SCENE`: the differences of each step, and what it refuses.

#include <nlohmann/json.hpp>

#include "tests/engine/cli/command_test.h"

namespace graze::tests {
namespace {

using CliCompareScene = CommandTest;

const std::string kScene = GRAZE_DATA_DIR "/scenes/shapes.json";

TEST_F(CliCompareScene, GrazeIsRightAboutTheBundledShapes) {
  const CommandResult result = graze({"compare", kScene, "--json", "--steps", "20"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto summary = nlohmann::json::parse(lines_of(result.out).back())["summary"];
  EXPECT_EQ(summary.at(0)["engine"], "world");
  EXPECT_EQ(summary.at(1)["engine"], "graze");
  EXPECT_EQ(summary.at(0)["answers"], 21 * 35);
  EXPECT_EQ(summary.at(0)["wrong"], 0);
  EXPECT_EQ(summary.at(1)["wrong"], 0);
}

/// FCL's managers are engines of scenes, and of nothing else unless they are named.
TEST_F(CliCompareScene, BroadPhasesTakePart) {
  const CommandResult scene =
      graze({"compare", kScene, "--json", "--steps", "3", "--engines", "fcl,fcl-sap,fcl-hash"});
  if (scene.err.find("was not found when this command was built") != std::string::npos)
    GTEST_SKIP() << "without FCL";
  EXPECT_EQ(scene.exit_code, 0) << scene.err;
  const auto summary = nlohmann::json::parse(lines_of(scene.out).back())["summary"];
  ASSERT_EQ(summary.size(), 5u) << summary;
  EXPECT_EQ(summary.at(3)["engine"], "fcl-sap");
  EXPECT_EQ(summary.at(3)["answers"], summary.at(2)["answers"]);
  EXPECT_EQ(summary.at(4)["answers"], summary.at(2)["answers"]);
  EXPECT_EQ(summary.at(4)["wrong"], summary.at(2)["wrong"]);
  const CommandResult meshes =
      graze({"compare", GRAZE_DATA_DIR "/regressions", "--engines", "fcl-sap"});
  EXPECT_EQ(meshes.exit_code, 2);
  EXPECT_NE(meshes.err.find("there is no engine \"fcl-sap\""), std::string::npos) << meshes.err;
}

/// A pellet that flies twelve metres a step meets a pane of glass, which only who looks between
/// steps sees.
TEST_F(CliCompareScene, WhomBodiesMeetOnTheirWays) {
  const std::string fast = GRAZE_DATA_DIR "/scenes/fast.json";
  const CommandResult result = graze({"compare", fast, "--json", "--steps", "3", "--query",
                                      "first_contact", "--engines", "graze", "--save", "base"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::vector<std::string> lines = lines_of(result.out);
  std::size_t seen = 0;
  for (const std::string& line : lines) {
    const auto each = nlohmann::json::parse(line);
    if (!each.contains("step") || each["a"] != "pane") continue;
    ++seen;
    EXPECT_EQ(each["b"], "pellet");
    EXPECT_EQ(each["step"], 2);
    for (const auto& answer : each["answers"])
      EXPECT_EQ(answer["says"], "hit at 0.333") << answer;
  }
  EXPECT_EQ(seen, 1u) << result.out;
  const auto summary = nlohmann::json::parse(lines.back())["summary"];
  EXPECT_EQ(summary.at(0)["engine"], "world");
  EXPECT_GT(summary.at(0)["right"], 0);
  EXPECT_EQ(summary.at(0)["wrong"], 0);
  EXPECT_EQ(summary.at(1)["wrong"], 0);
  const CommandResult again =
      graze({"compare", fast, "--steps", "3", "--query", "first_contact", "--engines", "graze",
             "--against", "base", "--time-tolerance", "1e9"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  const CommandResult other = graze({"compare", fast, "--steps", "3", "--query", "free",
                                     "--engines", "graze", "--against", "base"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("question"), std::string::npos) << other.err;
}

TEST_F(CliCompareScene, BadInputIsRefused) {
  expect_refusal({"compare", kScene, "--random", "3"},
                 "graze: a scene says itself where bodies are: poses belong to two meshes");
  expect_refusal({"compare", kScene, "--query", "distance"},
                 "graze: --query: of a scene each pair is asked any, at each step, or "
                 "first_contact or free, on the way there");
  expect_refusal({"compare", kScene, "--clearance", "1"},
                 "graze: --clearance belongs to --query within, first_contact and free");
  write("bad.json", "{\"graze_scene\": 3}");
  expect_refusal({"compare", "bad.json"},
                 "graze: bad.json:1: /graze_scene: is version 3; this program reads 1");
  const CommandResult nobody = graze({"compare", kScene, "--engines", "nobody"});
  EXPECT_EQ(nobody.exit_code, 2);
  EXPECT_NE(nobody.err.find("there is no engine \"nobody\", but graze, "), std::string::npos)
      << nobody.err;
  expect_refusal({"compare", kScene, "--seed", "3"},
                 "graze: a scene says itself where bodies are: poses belong to two meshes");
  for (const std::string option : {"--steps", "--keep", "--threads", "--seed"}) {
    const CommandResult result = graze({"compare", kScene, option, "010"});
    EXPECT_EQ(result.exit_code, 2) << option;
    EXPECT_NE(result.err.find("\"010\" is not a whole number from 0 to "), std::string::npos)
        << result.err;
  }
  expect_refusal({"compare", kScene, "--dt", "-1"},
                 "graze: --dt: \"-1\" is not a positive number (see graze compare --help)");
  expect_refusal({"compare", "a.off", "b.off", "--steps", "3"},
                 "graze: --steps, --dt and --meshes belong to scenes");
}

}  // namespace
}  // namespace graze::tests

// `graze pair --check fcl`.

#include <nlohmann/json.hpp>

#include "tests/engine/cli/command_test.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {
namespace {

using Json = nlohmann::ordered_json;

class CliCheck : public CommandTest {
 protected:
  CliCheck() {
    write_mesh("box.off", make_box({1, 1, 1}));
    write_mesh("sphere.off", make_sphere(1, 8, 12));
    write("poses.txt",
          "1 0 0 10 0 1 0 0 0 0 1 0\n"                    // apart
          "1 0 0 1.5 0 1 0 0.25 0 0 1 0.125\n"            // crossing
          "1 0 0 2 0 1 0 0 0 0 1 0\n"                     // touching in a point or a face
          "1 0 0 1.9999999999999998 0 1 0 0 0 0 1 0\n");  // into each other by one unit of rounding
  }

  Json check(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all = {"pair", "--check", "fcl", "--json"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const CommandResult result = graze(all);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    Json lines = Json::array();
    for (const std::string& line : lines_of(result.out))
      lines.push_back(Json::parse(line));
    return lines;
  }
};

TEST_F(CliCheck, FclAgreesAwayFromTouching) {
  const Json answers = check({"box.off", "sphere.off", "--poses", "poses.txt"});
  ASSERT_EQ(answers.size(), 4u);
  for (int i : {0, 1}) {
    const Json& fcl = answers[i]["fcl"];
    EXPECT_EQ(fcl["intersects"], answers[i]["intersects"]);
    EXPECT_EQ(fcl["pairs"], answers[i]["pairs"]);
    EXPECT_TRUE(fcl["differences"].empty());
  }
}

TEST_F(CliCheck, DifferencesNameTheirPairsAndTheTruth) {
  const Json answers = check({"box.off", "box.off", "--poses", "poses.txt"});
  std::size_t differences = 0;
  for (const Json& answer : answers) {
    const Json& fcl = answer["fcl"];
    EXPECT_EQ(fcl["graze_wrong"], 0);
    EXPECT_EQ(fcl["fcl_wrong"], fcl["differences"].size());
    for (const Json& difference : fcl["differences"]) {
      EXPECT_EQ(difference["pair"].size(), 2u);
      EXPECT_EQ(difference["graze"], difference["truth"]);
      EXPECT_NE(difference["fcl"], difference["truth"]);
      ++differences;
    }
  }
  EXPECT_GT(differences, 0u) << "faces that touch are where floating point fails";
}

TEST_F(CliCheck, BooleanAnswersAreCheckedWithoutPairs) {
  for (const Json& answer :
       check({"box.off", "box.off", "--poses", "poses.txt", "--query", "any"})) {
    const Json& fcl = answer["fcl"];
    EXPECT_FALSE(fcl.contains("pairs"));
    EXPECT_EQ(fcl["graze_wrong"], 0);
    EXPECT_EQ(fcl["differences"].size(), answer["intersects"] == fcl["intersects"] ? 0u : 1u);
  }
}

TEST_F(CliCheck, TheTableShowsBothAndTheSummaryCounts) {
  const CommandResult result =
      graze({"pair", "box.off", "box.off", "--poses", "poses.txt", "--check", "fcl"});
  EXPECT_EQ(result.exit_code, 0);
  const std::vector<std::string> lines = lines_of(result.out);
  ASSERT_GT(lines.size(), 4u);
  EXPECT_TRUE(lines.front().ends_with("fcl  graze wrong  fcl wrong")) << lines.front();
  EXPECT_NE(lines.back().find("; differences from fcl: graze wrong in 0, fcl wrong in "),
            std::string::npos)
      << lines.back();
}

}  // namespace
}  // namespace graze::tests

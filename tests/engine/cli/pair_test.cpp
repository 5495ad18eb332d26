// What `graze pair` answers, and that it is what the library says.

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/pair.h>

#include "tests/engine/cli/two_meshes.h"

namespace graze::tests {
namespace {

using Json = nlohmann::ordered_json;

class CliPair : public TwoMeshes {
 protected:
  std::vector<Json> json_lines(const std::vector<std::string>& options) const {
    std::vector<Json> objects;
    for (const std::string& line : lines_of(json_of("pair", options)))
      objects.push_back(Json::parse(line));
    return objects;
  }
};

TEST_F(CliPair, JsonHasThePromisedKeysInOrder) {
  const Json plain = json_lines({"--pose-b", kCrossing}).at(0);
  EXPECT_EQ(keys_of(plain), (Keys{"pose", "intersects", "pairs", "work"}));
  EXPECT_EQ(keys_of(plain["work"]), (Keys{"volume_tests", "volume_rejections", "filter_tests",
                                          "triangle_tests", "exact_tests", "points_tested",
                                          "skipped_by_memory", "trees_built", "skins_built"}));
  EXPECT_EQ(keys_of(json_lines({"--query", "any"}).at(0)), (Keys{"pose", "intersects", "work"}));
  EXPECT_EQ(keys_of(json_lines({"--list"}).at(0)),
            (Keys{"pose", "intersects", "pairs", "list", "work"}));
}

TEST_F(CliPair, VolumesChangeNoAnswer) {
  const Json expected = json_lines({"--pose-b", kCrossing, "--list"}).at(0)["list"];
  ASSERT_FALSE(expected.empty());
  for (const PairVolume volume : kPairVolumes) {
    const Json line =
        json_lines({"--pose-b", kCrossing, "--list", "--volume", name_of(volume)}).at(0);
    EXPECT_EQ(line["list"], expected) << name_of(volume);
    EXPECT_EQ(line["work"]["skins_built"] > 0,
              volume != PairVolume::WideObb && volume != PairVolume::Aabb)
        << name_of(volume);
  }
  EXPECT_EQ(graze({"pair", "a.off", "b.off", "--volume", "cone"}).exit_code, 2);
}

TEST_F(CliPair, ThreadsChangeNoAnswer) {
  const Json expected = json_lines({"--pose-b", kCrossing, "--list"}).at(0)["list"];
  for (const char* threads : {"0", "1", "3"})
    EXPECT_EQ(json_lines({"--pose-b", kCrossing, "--list", "--threads", threads}).at(0)["list"],
              expected);
  for (const char* wrong : {"-1", "1025", "two"})
    EXPECT_EQ(graze({"pair", "a.off", "b.off", "--threads", wrong}).exit_code, 2);
  EXPECT_EQ(graze({"pair", "a.off", "b.off", "--threads", "2", "--query", "any"}).exit_code, 2);
  EXPECT_EQ(graze({"pair", "a.off", "b.off", "--threads", "2", "--volume", "obb"}).exit_code, 2);
}

TEST_F(CliPair, TouchSaysWhichPairsCount) {
  const std::string on_top = "1 0 0 0 0 1 0 0 0 0 1 2";
  write_mesh("b.off", make_box({1, 1, 1}));
  EXPECT_EQ(json_lines({"--pose-b", on_top}).at(0)["intersects"], true);
  EXPECT_EQ(json_lines({"--pose-b", on_top, "--touch", "include"}).at(0)["intersects"], true);
  const Json plain = json_lines({"--pose-b", on_top, "--touch", "exclude", "--list"}).at(0);
  EXPECT_EQ(plain["intersects"], false);
  EXPECT_EQ(plain["pairs"], 0);
  EXPECT_EQ(plain["list"], Json::array());
  const std::vector<std::string> any = {"--query", "any", "--touch", "exclude", "--pose-b"};
  const auto with = [](std::vector<std::string> options, const std::string& pose) {
    options.push_back(pose);
    return options;
  };
  EXPECT_EQ(json_lines(with(any, on_top)).at(0)["intersects"], false);
  EXPECT_EQ(json_lines(with(any, kCrossing)).at(0)["intersects"], true);
  EXPECT_EQ(graze({"pair", "a.off", "b.off", "--touch", "maybe"}).exit_code, 2);
}

TEST_F(CliPair, SolidsHoldWhatIsWhollyInside) {
  write_mesh("a.off", make_box({4, 4, 4}));
  EXPECT_EQ(json_lines({}).at(0)["intersects"], false);
  const Json inside = json_lines({"--solid"}).at(0);
  EXPECT_EQ(inside["intersects"], true);
  EXPECT_EQ(inside["pairs"], 0);
  EXPECT_GT(inside["work"]["points_tested"], 0);
  EXPECT_EQ(json_lines({"--solid", "--query", "any"}).at(0)["intersects"], true);
  EXPECT_EQ(json_lines({"--solid", "--pose-b", kApart}).at(0)["intersects"], false);
}

TEST_F(CliPair, SolidsAreClosedMeshes) {
  write_mesh("open.off", make_row(2));
  expect_refusal(
      {"pair", "a.off", "open.off", "--solid"},
      "graze: --solid: open.off is not closed: it has 6 boundary edges, the first from vertex 0 to "
      "vertex 1 of triangle 0");
}

TEST_F(CliPair, SolidsThatTouchDoNotOverlap) {
  write_mesh("a.off", make_box({1, 1, 1}));
  write_mesh("b.off", make_box({1, 1, 1}));
  const auto ask = [&](const std::string& x, const std::string& query) {
    return json_lines({"--solid", "--touch", "exclude", "--query", query, "--pose-b",
                       "1 0 0 " + x + " 0 1 0 0 0 0 1 0"})
        .at(0);
  };
  for (const char* query : {"any", "pairs"}) {
    EXPECT_EQ(ask("2", query)["intersects"], false) << "wall against wall";
    EXPECT_EQ(ask("1", query)["intersects"], true) << "no triangles cross";
    EXPECT_EQ(ask("0", query)["intersects"], true) << "equal solids";
    EXPECT_EQ(ask("9", query)["intersects"], false);
  }
  EXPECT_EQ(ask("0", "pairs")["pairs"], 0);
}

TEST_F(CliPair, AnswersAreTheLibrarys) {
  const Mesh mesh_a = load_mesh(folder_ / "a.off");
  const Mesh mesh_b = load_mesh(folder_ / "b.off");
  Pose pose = Pose::Identity();
  pose.translation() << 1.5, 0.25, 0.125;
  const TrianglePairs pairs = find_triangle_pairs({mesh_a}, {mesh_b, pose});
  ASSERT_GT(pairs.size(), 1u);

  const Json answer = json_lines({"--pose-b", kCrossing, "--list"}).at(0);
  EXPECT_EQ(answer["pose"], 0);
  EXPECT_EQ(answer["intersects"], true);
  EXPECT_EQ(answer["pairs"], pairs.size());
  ASSERT_EQ(answer["list"].size(), pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(answer["list"][i], Json::array({pairs[i].a, pairs[i].b}));
  }
  EXPECT_EQ(json_lines({"--pose-b", kCrossing, "--query", "any"}).at(0)["intersects"], true);
  EXPECT_EQ(json_lines({"--pose-b", kApart, "--query", "any"}).at(0)["intersects"], false);
}

TEST_F(CliPair, PosesAreTakenInEveryWriting) {
  const Json expected = json_lines({"--pose-b", kCrossing, "--list"}).at(0)["list"];
  const std::vector<std::vector<std::string>> writings = {
      {"--pose-b", "1,0,0,1.5,0,1,0,0.25,0,0,1,0.125"},
      {"--pose-b", " 1, 0, 0, 1.5 ,\n 0, 1, 0, .25,\t0 0 1 +1.25e-1 "},
      {"--pose-b=" + kCrossing},
      {"--pose-b", "1", "0", "0", "1.5", "0", "1", "0", "0.25", "0", "0", "1", "0.125"},
      {"--pose-b", "1", "-0", "-.0", "1.5", "-0e5", "1", "0", "0.25", "0", "0", "1", "0.125"}};
  for (std::vector<std::string> writing : writings) {
    writing.push_back("--list");
    EXPECT_EQ(json_lines(writing).at(0)["list"], expected) << writing[1];
  }
}

TEST_F(CliPair, NegativeNumbersAreNoOptionsAndMeshesMayFollow) {
  const CommandResult result = graze({"pair", "--pose-b", "-1", "0", "0", "-.5", "0", "-1", "0",
                                      "-3e1", "0", "0", "1", "-7", "a.off", "b.off", "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(Json::parse(result.out)["intersects"], false);
  const CommandResult quoted =
      graze({"pair", "--pose-b", "-1 0 0 0 0 -1 0 0 0 0 1 0", "a.off", "b.off"});
  EXPECT_EQ(quoted.exit_code, 0) << quoted.err;
}

TEST_F(CliPair, MovingBothByOneShiftChangesNothing) {
  const Json both = json_lines({"--pose-a", kApart, "--pose-b", kApart, "--list"}).at(0);
  EXPECT_EQ(both["intersects"], true);
  const Json apart = json_lines({"--pose-a", kApart}).at(0);
  EXPECT_EQ(apart["intersects"], false);
  EXPECT_EQ(apart["pairs"], 0);
}

TEST_F(CliPair, EachPoseOfAFileIsALine) {
  write("poses.txt", kApart + "\r\n\n" + kCrossing + "\n  \n" + kApart);
  const std::vector<Json> answers = json_lines({"--poses", "poses.txt"});
  ASSERT_EQ(answers.size(), 3u);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    EXPECT_EQ(answers[i]["pose"], i);
    EXPECT_EQ(answers[i]["intersects"], i == 1);
  }
  EXPECT_EQ(answers[0]["pairs"], 0);
  EXPECT_GT(answers[1]["work"]["triangle_tests"], 0);
  EXPECT_EQ(answers[2]["work"]["trees_built"], 0);
}

TEST_F(CliPair, TheTableHasARowPerPoseAndASummary) {
  write("poses.txt", kApart + "\n" + kCrossing + "\n");
  const CommandResult result = graze({"pair", "a.off", "b.off", "--poses", "poses.txt"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  const std::vector<std::string> lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(
      lines[0],
      "  pose  intersects      pairs  volume tests  triangle tests  exact tests    time (us)");
  EXPECT_EQ(lines[1].substr(0, 29), "     0          no          0");
  EXPECT_EQ(lines[2].substr(0, 18), "     1         yes");
  EXPECT_EQ(lines[1].size(), lines[0].size());
  EXPECT_EQ(lines[2].size(), lines[0].size());
  EXPECT_EQ(lines[3].substr(0, 22), "2 poses, 1 intersects,");
}

TEST_F(CliPair, TheTableListsPairsUnderTheirRow) {
  const std::size_t pairs = json_lines({"--pose-b", kCrossing}).at(0)["pairs"];
  const CommandResult result = graze({"pair", "a.off", "b.off", "--pose-b", kCrossing, "--list"});
  EXPECT_EQ(lines_of(result.out).size(), pairs + 3);
  const CommandResult any = graze({"pair", "a.off", "b.off", "--query", "any"});
  EXPECT_EQ(lines_of(any.out)[0],
            "  pose  intersects  volume tests  triangle tests  exact tests    time (us)");
}

TEST_F(CliPair, OneFileTwiceIsOneMesh) {
  const CommandResult result = graze({"pair", "b.off", "b.off", "--json"});
  const Json answer = Json::parse(result.out);
  EXPECT_EQ(answer["work"]["trees_built"], 1);
  EXPECT_GE(answer["pairs"], load_mesh(folder_ / "b.off").triangles().size());
}

TEST_F(CliPair, AClosedPipeEndsItQuietly) {
  std::string poses;
  for (int i = 0; i < 20000; ++i)
    poses += kApart + "\n";
  write("poses.txt", poses);
  const CommandResult result = run_shell(
      folder_,
      "{ \"$GRAZE\" pair a.off b.off --poses poses.txt --json; echo $? >&2; } | head -n 2");
  EXPECT_EQ(lines_of(result.out).size(), 2u);
  EXPECT_EQ(result.err, "0\n");
}

TEST_F(CliPair, ProgressIsReportedOnRequestOnly) {
  // The reader keeps the command waiting until its work counts as long.
  std::string poses;
  for (int i = 0; i < 5000; ++i)
    poses += kApart + "\n";
  write("poses.txt", poses);
  const CommandResult result =
      run_shell(folder_,
                "ask() { \"$GRAZE\" pair a.off b.off --poses poses.txt --json $1 2> $2 |"
                " { sleep 2.5; cat > $3; }; };"
                "ask '' silent lines1 & ask --progress reports lines2; wait;"
                "cat silent; echo; head -n 1 reports; cmp lines1 lines2 && wc -l < lines1");
  EXPECT_EQ(result.err, "");
  const std::vector<std::string> lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 3u) << result.out;
  EXPECT_EQ(lines[0], "");
  EXPECT_TRUE(lines[1].starts_with("poses: ") && lines[1].ends_with(" of 5000 done")) << lines[1];
  EXPECT_EQ(std::stoi(lines[2]), 5000);
}

TEST_F(CliPair, AFullDiskIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const CommandResult result = run_shell(folder_, "\"$GRAZE\" pair a.off b.off > /dev/full");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err, "graze: cannot write to standard output: No space left on device\n");
}

}  // namespace
}  // namespace graze::tests

// `graze view`: what its pages show, says and refuses.

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/engine/cli/command_test.h"
#include "tests/engine/view/unpacked_page.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {
namespace {

class CliView : public CommandTest {
 protected:
  CliView() {
    write_mesh("torus.off", make_torus(1, 0.3, 20, 12));
    write("poses.txt",
          "1 0 0 0  0 1 0 0  0 0 1 5\n\n1 0 0 0.5  0 1 0 0  0 0 1 0\n1 0 0 9  0 1 0 0  0 0 1 0\n");
  }

  UnpackedPage page(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return UnpackedPage(std::string(std::istreambuf_iterator<char>(file), {}));
  }

  void refuse(const std::vector<std::string>& arguments, const std::string& why) const {
    const CommandResult result = graze(arguments);
    EXPECT_EQ(result.exit_code, 2) << why;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(why), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "graze-view.html")) << why;
  }
};

TEST_F(CliView, EachPoseIsAPictureThatSaysWhetherTheyTouch) {
  const CommandResult result =
      graze({"view", "torus.off", "torus.off", "--poses", "poses.txt", "-o", "p.html"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out.substr(0, result.out.rfind(',')), "p.html: 3 pictures, 1 touching");
  const UnpackedPage shown = page("p.html");
  const auto& frames = shown.json()["frames"];
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames[0]["label"], "line 1");
  EXPECT_EQ(frames[1]["label"], "line 3");
  EXPECT_EQ(frames[0]["state"], "clear");
  EXPECT_EQ(frames[1]["state"], "touching");
  EXPECT_EQ(frames[2]["state"], "clear");
  EXPECT_EQ(frames[0]["facts"][0]["name"], "gap");
  EXPECT_NEAR(frames[0]["facts"][0]["value"].get<double>(), 4.4, 0.01);
  EXPECT_EQ(shown.json()["meshes"].size(), 1u) << "one file is one mesh";
  EXPECT_EQ(shown.marks("gaps", 7, 0).size(), 7u);
  EXPECT_TRUE(shown.marks("gaps", 7, 1).empty());
  EXPECT_FALSE(shown.marks("curves", 6, 1).empty());
  EXPECT_FALSE(shown.marks("contacts", 7, 1).empty());
  EXPECT_EQ(shown.json()["marks"]["triangles"].size(), 2u);
}

TEST_F(CliView, ThePageHasTheNumbersOfGrazePair) {
  const std::vector<std::string> meshes = {"torus.off", "torus.off", "--pose-b",
                                           "1 0 0 0.5  0 1 0 0  0 0 1 0"};
  std::vector<std::string> pair = {"pair"}, view = {"view"};
  pair.insert(pair.end(), meshes.begin(), meshes.end());
  view.insert(view.end(), meshes.begin(), meshes.end());
  pair.push_back("--json");
  const auto expected = nlohmann::json::parse(graze(pair).out);
  view.push_back("--json");
  const CommandResult result = graze(view);
  ASSERT_EQ(result.exit_code, 0);
  const auto said = nlohmann::json::parse(result.out);
  EXPECT_EQ(said["pictures"], 1);
  EXPECT_EQ(said["touching"], 1);
  EXPECT_EQ(said["bytes"], std::filesystem::file_size(folder_ / "graze-view.html"));
  const auto facts = page("graze-view.html").json()["frames"][0]["facts"];
  EXPECT_EQ(facts[0]["name"], "pairs of triangles");
  EXPECT_EQ(facts[0]["value"].get<double>(), expected["pairs"].get<double>());
}

TEST_F(CliView, APlaneIsDrawnWhereOneSeparates) {
  // Apart along z, then linked like a chain: no plane separates these.
  write("two.txt", "1 0 0 0  0 1 0 0  0 0 1 5\n1 0 0 1  0 0 -1 0  0 1 0 0\n");
  ASSERT_EQ(
      graze({"view", "torus.off", "torus.off", "--poses", "two.txt", "-o", "p.html"}).exit_code, 0);
  const UnpackedPage shown = page("p.html");
  EXPECT_EQ(shown.json()["frames"][1]["state"], "clear");
  const std::vector<float> plane = shown.marks("planes", 7, 0);
  ASSERT_EQ(plane.size(), 7u);
  EXPECT_NEAR(shown.world(0, Eigen::Vector3d(plane[0], plane[1], plane[2])).z(), 2.5, 1e-5);
  EXPECT_NEAR(std::abs(plane[5]), 1, 1e-5);
  EXPECT_TRUE(shown.marks("planes", 7, 1).empty());
}

TEST_F(CliView, BoxesOfTreesHoldTheMeshLevelByLevel) {
  for (const std::string kind : {"aabb", "obb"}) {
    ASSERT_EQ(graze({"view", "torus.off", "--tree", kind, "-o", "p.html"}).exit_code, 0);
    const UnpackedPage shown = page("p.html");
    const std::vector<float> vertices = shown.floats(shown.json()["meshes"][0]["positions"]);
    const auto boxes = shown.json()["marks"]["boxes"];
    ASSERT_GT(boxes.size(), 4u);
    for (std::size_t level = 0; level < 4; ++level) {
      EXPECT_EQ(boxes[level]["level"], level);
      const std::vector<float> numbers = shown.floats(boxes[level]["list"]);
      ASSERT_EQ(numbers.size(), 12u << level) << "of 480 triangles none is a leaf yet";
      for (std::size_t v = 0; v < vertices.size(); v += 3) {
        bool is_held = false;
        for (std::size_t b = 0; b < numbers.size(); b += 12) {
          const auto at = [&](std::size_t i) {
            return Eigen::Vector3d(numbers[b + i], numbers[b + i + 1], numbers[b + i + 2]);
          };
          const Eigen::Vector3d from =
              Eigen::Vector3d(vertices[v], vertices[v + 1], vertices[v + 2]) - at(0);
          bool is_in = true;
          for (const std::size_t axis : {3u, 6u, 9u})
            is_in &= std::abs(from.dot(at(axis))) <= at(axis).squaredNorm() * (1 + 1e-5) + 1e-12;
          is_held |= is_in;
        }
        EXPECT_TRUE(is_held) << kind << " " << level << " vertex " << v / 3;
      }
    }
  }
}

TEST_F(CliView, OneMeshStandsByItself) {
  ASSERT_EQ(graze({"view", "torus.off", "--title", "one <b>"}).exit_code, 0);
  const UnpackedPage shown = page("graze-view.html");
  EXPECT_EQ(shown.json()["title"], "one <b>");
  EXPECT_EQ(shown.json()["bodies"][0]["name"], "torus.off");
  EXPECT_EQ(shown.json()["frames"][0]["state"], "");
}

TEST_F(CliView, APageIsOpenedByTheProgramOfTheDesktop) {
  write("xdg-open", "#!/bin/sh\necho \"$1\" >opened\n");
  std::filesystem::permissions(folder_ / "xdg-open", std::filesystem::perms::owner_all);
  ASSERT_EQ(run_shell(folder_, "PATH=$PWD:$PATH $GRAZE view torus.off --open").exit_code, 0);
  std::ifstream file(folder_ / "opened");
  std::string opened;
  std::getline(file, opened);
  EXPECT_EQ(opened, (folder_ / "graze-view.html").string());

  const CommandResult none =
      run_shell(folder_, "PATH=/none $GRAZE view torus.off -o p.html --open");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("--open: xdg-open has not opened"), std::string::npos) << none.err;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "p.html")) << "written all the same";
}

TEST_F(CliView, AMotionIsPlayedUpToWhereTheyMeet) {
  const std::vector<std::string> motion = {"motion",
                                           "torus.off",
                                           "torus.off",
                                           "--from",
                                           "1 0 0 0  0 1 0 0  0 0 1 5",
                                           "--to",
                                           "1 0 0 0  0 1 0 0  0 0 1 0"};
  std::vector<std::string> viewed = motion;
  viewed.insert(viewed.end(), {"--json", "--view", "m.html"});
  const CommandResult result = graze(viewed);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto answer = nlohmann::json::parse(result.out);
  ASSERT_EQ(answer["answer"], "hit");
  const auto frames = page("m.html").json()["frames"];
  ASSERT_EQ(frames.size(), 50u) << "49 even times, and the hit";
  // The rings are 0.6 high: they meet after 4.4 of 5 metres.
  std::size_t meeting = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string label = frames[i]["label"];
    if (label.find("they meet") != label.npos) meeting = i;
    EXPECT_EQ(frames[i]["state"] == "touching", meeting > 0) << label;
  }
  EXPECT_EQ(frames[meeting]["label"].get<std::string>().substr(0, 8), "t = 0.88");

  std::vector<std::string> path = {"motion",    "torus.off", "torus.off", "--path",
                                   "poses.txt", "--view",    "p.html"};
  ASSERT_EQ(graze(path).exit_code, 0);
  const auto of_path = page("p.html").json()["frames"];
  EXPECT_EQ(of_path[0]["label"], "motion 0, t = 0");
  EXPECT_EQ(of_path.back()["label"], "motion 1, t = 1");
  path.back() = "torus.off";
  EXPECT_EQ(graze(path).exit_code, 2) << "a mesh is not overwritten";
}

TEST_F(CliView, WhatExplainSaysIsShownByTheTrianglesThatDecide) {
  for (const auto& [place, state] : {std::pair("0.5", "touching"), std::pair("5", "clear")}) {
    const std::string pose = std::string("1 0 0 ") + place + "  0 1 0 0  0 0 1 0";
    const std::vector<std::string> words = {"explain", "torus.off", "torus.off", "--pose-b",
                                            pose,      "--json",    "--view",    "why.html"};
    const CommandResult result = graze(words);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto said = nlohmann::json::parse(result.out);
    const UnpackedPage shown = page("why.html");
    ASSERT_EQ(shown.json()["frames"].size(), 2u);
    EXPECT_EQ(shown.json()["frames"][0]["state"], state);
    EXPECT_EQ(shown.json()["frames"][1]["state"], state);
    for (std::size_t body = 0; body < 2; ++body) {
      const auto mark = shown.json()["marks"]["triangles"][body];
      const std::vector<std::uint32_t> frames = shown.words(mark["frames"]),
                                       starts = shown.words(mark["starts"]),
                                       list = shown.words(mark["list"]);
      ASSERT_EQ(frames.back(), 1u);
      ASSERT_EQ(starts[starts.size() - 1] - starts[starts.size() - 2], 1u);
      EXPECT_EQ(list.back(), said["pair"][body].get<std::uint32_t>());
    }
    const bool is_clear = std::string(state) == "clear";
    EXPECT_EQ(shown.marks("planes", 7, 1).size(), is_clear ? 7u : 0u);
    EXPECT_EQ(shown.marks("points", 3, 1).size(), is_clear ? 0u : 3u);
  }
  const std::string wrong = std::string(GRAZE_DATA_DIR) + "/regressions/fcl-rock-14.json";
  ASSERT_EQ(graze({"explain", wrong, "--view", "case.html"}).exit_code, 0);
  const auto frame = page("case.html").json()["frames"][0];
  EXPECT_NE(frame["note"].get<std::string>().find("the truth is"), std::string::npos);
}

TEST_F(CliView, EveryBundledCaseIsShown) {
  const std::string cases = std::string(GRAZE_DATA_DIR) + "/regressions";
  const CommandResult result = graze({"view", cases, "-o", "cases.html"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const UnpackedPage shown = page("cases.html");
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(cases))
    files += entry.path().extension() == ".json" ? 1 : 0;
  EXPECT_EQ(shown.json()["places"].size(), files) << "each has a place of its own";
  for (const auto& frame : shown.json()["frames"])
    EXPECT_NE(frame["label"], "");
}

TEST_F(CliView, ASceneIsAPictureEachStepWithTheNumbersOfGrazeSimulate) {
  for (const std::string name : {"parts", "shapes", "fast"}) {
    const std::string scene = std::string(GRAZE_DATA_DIR) + "/scenes/" + name + ".json";
    const CommandResult result = graze({"view", scene, "-o", "scene.html"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::vector<std::string> steps = lines_of(graze({"simulate", scene, "--json"}).out);
    const UnpackedPage shown = page("scene.html");
    ASSERT_EQ(shown.json()["frames"].size(), steps.size()) << name;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const auto expected = nlohmann::json::parse(steps[i]);
      const auto frame = shown.json()["frames"][i];
      EXPECT_EQ(frame["facts"][0]["value"].get<double>(), expected["touching"].get<double>());
      const std::vector<std::uint32_t> starts =
          shown.words(shown.json()["marks"]["pairs"]["starts"]);
      // Of compounds each pair of parts is one.
      EXPECT_GE(starts[i + 1] - starts[i], expected["touching"].get<std::size_t>());
      EXPECT_EQ(starts[i + 1] > starts[i], expected["touching"].get<std::size_t>() > 0);
      EXPECT_EQ(frame["change"].get<bool>(),
                i > 0 && expected["begun"].size() + expected["ended"].size() > 0)
          << name << " " << i;
    }
  }
}

TEST_F(CliView, CasesThatCannotBeReadAreNamedAndTheOthersShown) {
  std::filesystem::create_directory(folder_ / "cases");
  std::filesystem::copy_file(std::string(GRAZE_DATA_DIR) + "/regressions/by-hand-boxes.json",
                             folder_ / "cases/good.json");
  write("cases/bad.json", "{");
  const CommandResult result = graze({"view", "cases", "-o", "p.html"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("cases/bad.json"), std::string::npos);
  const auto notes = page("p.html").json()["notes"];
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].get<std::string>().find("Left out: cases/bad.json"), std::string::npos);
}

TEST_F(CliView, WhatDoesNotGoTogetherIsRefused) {
  write("case.json", "{");
  refuse({"view"}, "FILE");
  refuse({"view", "torus.off", "case.json"}, "meshes and cases go to pages of their own");
  refuse({"view", "torus.off", "torus.off", "torus.off"}, "more than two meshes");
  refuse({"view", "torus.off", "--poses", "poses.txt"}, "need a second mesh");
  refuse({"view", "torus.off", "torus.off", "--poses", "poses.txt", "--pose-b",
          "1 0 0 0  0 1 0 0  0 0 1 0"},
         "exclude each other");
  refuse({"view", "case.json", "--pose-b", "1 0 0 0  0 1 0 0  0 0 1 0"}, "cases have their own");
  refuse({"view", "torus.off", "--meshes", "."}, "--meshes is about cases");
  refuse({"view", "case.json"}, "case.json:1");
  refuse({"view", "case.json", "--tree", "obb"}, "--tree is about meshes");
  refuse({"view", "torus.off", "--tree", "sphere"}, "--tree");
  refuse({"view", "none.off"}, "none.off");
  refuse({"view", "torus.off", "-o", "none/p.html"}, "none/p.html: cannot be written");
  refuse({"view", "torus.off", "-o", "torus.off"}, "torus.off");
  refuse({"view", "torus.off", "torus.off", "--pose-b", "2 0 0 0  0 1 0 0  0 0 1 0"}, "--pose-b");
}

}  // namespace
}  // namespace graze::tests

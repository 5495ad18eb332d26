// `graze simulate`: which pairs begin and end at which step, and what it refuses.

#include <nlohmann/json.hpp>

#include "tests/engine/cli/command_test.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFallingBall = R"({"graze_scene": 1, "step": 0.5, "steps": 4,
 "shapes": [{"name": "ball", "sphere": {"radius": 1}}, {"name": "floor", "half_space": {"normal": [0, 0, 1]}}],
 "bodies": [{"name": "floor", "shape": "floor", "motion": "static"},
            {"name": "ball", "shape": "ball", "pose": {"position": [0, 0, 2]},
             "path": {"velocity": [0, 0, -1]}}]})";

class CliSimulate : public CommandTest {
 protected:
  CliSimulate() { write("scene.json", kFallingBall); }

  std::vector<Json> json(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {"simulate", "scene.json", "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const CommandResult result = graze(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    std::vector<Json> steps;
    for (const std::string& line : lines_of(result.out))
      steps.push_back(Json::parse(line));
    return steps;
  }
};

TEST_F(CliSimulate, StepsSayWhatBeginsAndEnds) {
  const std::vector<Json> steps = json({});
  ASSERT_EQ(steps.size(), 5u);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(steps[i]["step"], i);
    EXPECT_EQ(steps[i]["time"], 0.5 * static_cast<double>(i));
    EXPECT_EQ(steps[i]["touching"], i < 2 ? 0 : 1);
    EXPECT_EQ(steps[i]["begun"],
              i == 2 ? Json::array({Json::array({"floor", "ball"})}) : Json::array());
    EXPECT_EQ(steps[i]["ended"], Json::array());
    EXPECT_FALSE(steps[i].contains("contacts"));
    EXPECT_TRUE(steps[i]["work"].contains("shape_tests"));
  }
}

TEST_F(CliSimulate, ContactsAreListedOnRequest) {
  const std::vector<Json> steps = json({"--contacts", "--steps", "1", "--dt", "1.5"});
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0]["contacts"], Json::array());
  const Json& contact = steps[1]["contacts"].at(0);
  EXPECT_EQ(contact["a"], "floor");
  EXPECT_EQ(contact["b"], "ball");
  EXPECT_EQ(contact["points"].at(0)["depth"], 0.5);
  EXPECT_EQ(contact["points"].at(0)["normal"], Json::array({0.0, 0.0, 1.0}));
  EXPECT_EQ(contact["points"].at(0)["point"].at(2), -0.25);
  EXPECT_EQ(contact["points"].at(0)["point_a"].at(2), 0.0);
  EXPECT_EQ(contact["points"].at(0)["point_b"].at(2), -0.5);
}

TEST_F(CliSimulate, ATableNamesThePairs) {
  const CommandResult result = graze({"simulate", "scene.json", "--contacts"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::vector<std::string> lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 10u);
  EXPECT_EQ(lines[4], "  begun: floor - ball");
  EXPECT_EQ(lines[5], "  contact: floor - ball: depth 0, normal (0, 0, 1), point (0, 0, 0)");
}

/// Two balls that meet at time 1, and one that is never near.
TEST_F(CliSimulate, MeshesThatNobodyWalksHaveNoTree) {
  for (const char* name : {"a.off", "b.off", "c.off"})
    write_mesh(name, make_sphere(1, 8, 12));
  write("scene.json", R"({"graze_scene": 1, "step": 1, "steps": 1, "shapes": [
    {"name": "a", "mesh": {"file": "a.off"}}, {"name": "b", "mesh": {"file": "b.off"}},
    {"name": "c", "mesh": {"file": "c.off"}}], "bodies": [
    {"name": "a", "shape": "a", "path": {"velocity": [2.5, 0, 0]}},
    {"name": "b", "shape": "b", "pose": {"position": [4, 0, 0]}},
    {"name": "c", "shape": "c", "pose": {"position": [0, 9, 0]}}]})");
  const std::vector<Json> steps = json({});
  ASSERT_EQ(steps.size(), 2u);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(steps[i]["work"]["trees_unbuilt"], i == 0 ? 3 : 1) << i;
    EXPECT_EQ(steps[i]["work"]["trees_built"], i == 1 ? 2 : 0) << i;
  }
  const std::vector<std::string> lines = lines_of(graze({"simulate", "scene.json"}).out);
  ASSERT_GE(lines.size(), 2u);
  EXPECT_TRUE(lines[0].ends_with("no tree")) << lines[0];
  EXPECT_TRUE(lines[1].ends_with(" 3")) << lines[1];
}

TEST_F(CliSimulate, BundledScenesRun) {
  const std::string data = GRAZE_DATA_DIR;
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"simulate", data + "/scenes/shapes.json", "--threads", "2"},
        {"simulate", data + "/scenes/machine.json", "--meshes", data + "/meshes", "--steps",
         "3"}}) {
    const CommandResult result = graze(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
}

TEST_F(CliSimulate, FastBodiesAreToldWhomTheyMet) {
  const std::string scene = std::string(GRAZE_DATA_DIR) + "/scenes/fast.json";
  const CommandResult result = graze({"simulate", scene, "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  std::vector<Json> steps;
  for (const std::string& line : lines_of(result.out))
    steps.push_back(Json::parse(line));
  ASSERT_EQ(steps.size(), 5u);
  EXPECT_EQ(steps[0]["first_contacts"], Json::array());
  // At 150 m/s the pellet is 10 m less the pane and itself away at time 0.
  const Json& met = steps[2]["first_contacts"].at(2);
  EXPECT_EQ(met["a"], "pane");
  EXPECT_EQ(met["b"], "pellet");
  EXPECT_EQ(met["status"], "hit");
  EXPECT_EQ(met["is_at_start"], false);
  EXPECT_NEAR(met["time"].get<double>(), (10 - 0.0025) / 150, 1e-7);
  EXPECT_EQ(steps[2]["work"]["pairs_swept"], 3);
  // The die touches the room all the while, and then its wall.
  const Json &floor = steps[3]["first_contacts"].at(1), &wall = steps[3]["first_contacts"].at(2);
  EXPECT_EQ(floor["is_at_start"], true);
  EXPECT_EQ(wall["a"], "room");
  EXPECT_EQ(wall["b"], "die");
  EXPECT_NEAR(wall["normal"].at(0).get<double>(), -1, 1e-9);
  const std::vector<std::string> lines = lines_of(graze({"simulate", scene}).out);
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                          [](const std::string& line) { return line.starts_with("  met: "); }),
            3);
  EXPECT_NE(std::find(lines.begin(), lines.end(), "  touched before: room - die"), lines.end());
}

TEST_F(CliSimulate, WhatIsSweptTurnsByLessThanHalfATurn) {
  write("top.json", R"({"graze_scene": 1, "units": {"angle": "turn"}, "step": 0.5,
 "shapes": [{"name": "top", "cone": {"radius": 1, "half_height": 1}}],
 "bodies": [{"name": "top", "shape": "top", "detection": "continuous",
             "path": {"axis": [0, 0, 1], "rate": 1}}]})");
  expect_refusal({"simulate", "top.json"},
                 "graze: body \"top\" turns by half a turn or more in a step of 0.500000 s: it "
                 "cannot be swept the long way round");
  EXPECT_EQ(graze({"simulate", "top.json", "--dt", "0.25"}).exit_code, 0);
}

TEST_F(CliSimulate, BadInputIsRefused) {
  write("bad.json", "{\"graze_scene\": 1, \"shapes\": [],\n\"bodies\": [{\"name\": 7}]}");
  expect_refusal({"simulate", "bad.json"},
                 "graze: bad.json:2: /bodies/0/name: is a number, not a string");
  expect_refusal({"simulate", "none.json"}, "graze: none.json: does not exist");
  expect_refusal({"simulate", GRAZE_DATA_DIR "/regressions/fcl-rock-14.json"},
                 "graze: " GRAZE_DATA_DIR
                 "/regressions/fcl-rock-14.json:1: unknown key "
                 "\"graze_case\"; there are graze_scene, note, units, step, steps, shapes, bodies, "
                 "exclusions");
  write("far.json", R"({"graze_scene": 1, "shapes": [{"name": "s", "sphere": {"radius": 1}}],
    "bodies": [{"name": "b", "shape": "s", "path": {"velocity": [1e99, 0, 0]}}]})");
  const CommandResult far = graze({"simulate", "far.json", "--dt", "1"});
  EXPECT_EQ(far.exit_code, 2);
  EXPECT_EQ(far.out, "");
  EXPECT_EQ(far.err.find("graze: body \"b\" at 100.000000 s: "), 0u) << far.err;
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--steps", "-1"},
                                                  {"--dt", "0"},
                                                  {"--dt", "nan"},
                                                  {"--threads", "-1"}}) {
    std::vector<std::string> arguments = {"simulate", "scene.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(graze(arguments).exit_code, 2) << options[0] << options[1];
  }
}

}  // namespace
}  // namespace graze::tests

// Scenes in a world: what the files say, and that the world's pairs are those of brute force.

#include <graze/engine/scenes/read_scene.h>
#include <graze/engine/scenes/simulation.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

Scene bundled(const std::string& name) {
  return read_scene(GRAZE_DATA_DIR "/scenes/" + name, {.mesh_folder = GRAZE_DATA_DIR "/meshes"});
}

const SceneBody& body_named(const Scene& scene, const std::string& name) {
  return *std::find_if(scene.bodies.begin(), scene.bodies.end(),
                       [&](const SceneBody& body) { return body.name == name; });
}

std::set<ScenePair> by_brute_force(const Scene& scene, double time) {
  std::vector<Pose> poses;
  for (const SceneBody& body : scene.bodies)
    poses.push_back(pose_at(body, time));
  std::set<ScenePair> pairs;
  for (const ScenePair pair : meeting_pairs(scene)) {
    const Shape& a = scene.shapes[scene.bodies[pair.a].shape].shape;
    const Shape& b = scene.shapes[scene.bodies[pair.b].shape].shape;
    if (intersects({a, poses[pair.a]}, {b, poses[pair.b]})) pairs.insert(pair);
  }
  return pairs;
}

std::set<ScenePair> set_of(std::span<const BodyPair> pairs) {
  std::set<ScenePair> result;
  for (const BodyPair& pair : pairs)
    result.insert({pair.a.index, pair.b.index});
  return result;
}

class Law9BundledScenes : public testing::TestWithParam<const char*> {};

TEST_P(Law9BundledScenes, WorldsFindThePairsOfBruteForce) {
  const Scene scene = bundled(GetParam());
  Simulation simulation(scene);
  std::set<ScenePair> touching;
  std::size_t begun = 0;
  for (std::size_t step = 0; step <= scene.steps; ++step) {
    const WorldUpdate update = simulation.advance();
    EXPECT_EQ(simulation.steps(), step);
    EXPECT_EQ(simulation.time(), static_cast<double>(step) * scene.step);
    for (const ScenePair& pair : set_of(update.begun))
      EXPECT_TRUE(touching.insert(pair).second) << step;
    for (const ScenePair& pair : set_of(update.ended))
      EXPECT_EQ(touching.erase(pair), 1u) << step;
    begun += update.begun.size();
    EXPECT_EQ(touching, by_brute_force(scene, simulation.time())) << step;
    EXPECT_EQ(touching, set_of(simulation.world().pairs())) << step;
  }
  EXPECT_GT(begun, 5u);
}

INSTANTIATE_TEST_SUITE_P(Data, Law9BundledScenes, testing::Values("shapes.json", "machine.json"),
                         [](const auto& each) {
                           const std::string name = each.param;
                           return name.substr(0, name.find('.'));
                         });

TEST(Scene, BundledShapesAreOfAllKinds) {
  std::set<ShapeKind> kinds;
  const Scene scene = bundled("shapes.json");
  for (const SceneShape& shape : scene.shapes)
    kinds.insert(shape.shape.kind());
  EXPECT_EQ(kinds.size(), tests::kOwnKinds.size());
  const Scene machine = bundled("machine.json");
  EXPECT_EQ(machine.step, 0.02);
  EXPECT_EQ(body_named(machine, "pinion").pose.translation(), Eigen::Vector3d(0.05, 0, 2.1));
  EXPECT_EQ(std::get<SteadyPath>(body_named(machine, "nut").path).rate, -1);
  EXPECT_EQ(std::get<SteadyPath>(body_named(machine, "nut").path).velocity.z(), -0.00125);
}

constexpr const char* kTwoBalls = R"({"graze_scene": 1, "units": {"length": "cm"},
  "shapes": [{"name": "ball", "sphere": {"radius": 100}}],
  "bodies": [
    {"name": "a", "shape": "ball"FILTER_A},
    {"name": "b", "shape": "ball", "pose": {"position": [150, 0, 0]}FILTER_B}]EXCLUSIONS})";

std::size_t pairs_with(const std::string& filter_a, const std::string& filter_b,
                       const std::string& exclusions = "") {
  std::string text = kTwoBalls;
  const auto put = [&](const std::string& mark, const std::string& value) {
    text.replace(text.find(mark), mark.size(), value);
  };
  put("FILTER_A", filter_a);
  put("FILTER_B", filter_b);
  put("EXCLUSIONS", exclusions);
  const Scene scene = parse_scene(text, "scene");
  Simulation simulation(scene);
  const std::size_t begun = simulation.advance().begun.size();
  EXPECT_EQ(begun, meeting_pairs(scene).size());
  return begun;
}

TEST(Scene, FiltersMotionsAndExclusionsKeepPairsApart) {
  EXPECT_EQ(pairs_with("", ""), 1u);
  EXPECT_EQ(pairs_with(R"(, "motion": "static")", R"(, "motion": "kinematic")"), 0u);
  EXPECT_EQ(pairs_with(R"(, "motion": "static")", R"(, "motion": "dynamic")"), 1u);
  EXPECT_EQ(pairs_with(R"(, "filter": {"category": 4})", R"(, "filter": {"mask": 3})"), 0u);
  EXPECT_EQ(pairs_with(R"(, "filter": {"group": -2})", R"(, "filter": {"group": -2})"), 0u);
  EXPECT_EQ(pairs_with(R"(, "filter": {"group": 7, "mask": 0})", R"(, "filter": {"group": 7})"),
            1u);
  EXPECT_EQ(pairs_with("", "", R"(, "exclusions": [["b", "a"]])"), 0u);
}

TEST(Scene, UnitsAndPosesAreConvertedOnce) {
  const Scene scene = parse_scene(R"({"graze_scene": 1, "units": {"length": "mm", "angle": "turn"},
    "shapes": [{"name": "s", "sphere": {"radius": "0x1.9p+6", "centre": [1, 2, 3]}},
               {"name": "h", "half_space": {"normal": [0, 0, 2], "offset": 5}}],
    "bodies": [{"name": "a", "shape": "s", "pose": [0, -1, 0, 7, 1, 0, 0, 8, 0, 0, 1, 9]},
               {"name": "b", "shape": "s", "pose": {"position": [7, 8, 9], "axis": [0, 0, 3], "angle": 0.25}},
               {"name": "c", "shape": "h", "motion": "static"}]})",
                                  "scene");
  EXPECT_EQ(scene.shapes[0].shape.as<Sphere>()->radius, 0.1);
  EXPECT_EQ(scene.shapes[0].shape.as<Sphere>()->centre, Eigen::Vector3d(0.001, 0.002, 0.003));
  EXPECT_EQ(scene.shapes[1].shape.as<HalfSpace>()->offset, 0.0025);
  EXPECT_EQ(scene.bodies[0].pose.translation(), Eigen::Vector3d(0.007, 0.008, 0.009));
  EXPECT_LE((scene.bodies[0].pose.matrix() - scene.bodies[1].pose.matrix()).cwiseAbs().maxCoeff(),
            0x1p-52);
}

TEST(Simulation, RefusesStepsAndPathsThatLeadNowhere) {
  const Scene scene = parse_scene(R"({"graze_scene": 1,
    "shapes": [{"name": "s", "sphere": {"radius": 1}}],
    "bodies": [{"name": "far", "shape": "s", "path": {"velocity": [1e99, 0, 0]}}]})",
                                  "scene");
  EXPECT_THROW(Simulation(scene, {.step = -1}), InputError);
  EXPECT_NO_THROW(check_paths(scene, 1));
  EXPECT_THROW(check_paths(scene, 20), PoseError);
  Simulation simulation(scene, {.step = 20});
  simulation.advance();
  try {
    simulation.advance();
    FAIL();
  } catch (const PoseError& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 28), "body \"far\" at 20.000000 s: p");
  }
}

}  // namespace
}  // namespace graze

// Bodies of a scene on their ways from step to step: times that are known from a formula, engines
// that see no motion, and the world beside each pair alone.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/compare/run/job_key.h>
#include <graze/engine/compare/run/scene_comparison.h>
#include <graze/engine/scenes/read_scene.h>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <vector>

#include "tests/compare/each_record.h"
#include "tests/compare/engine_doubles.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::compare {
namespace {

Pose at(double x, double y = 0) {
  return Pose(Eigen::Translation3d(x, y, 0));
}

SceneBody flying(const std::string& name, std::size_t shape, const Pose& start) {
  return {.name = name,
          .shape = shape,
          .pose = start,
          .path = SteadyPath{.velocity = {8, 0, 0}, .axis = {0, 0, 1}, .rate = 0}};
}

/// A ball and a cube of triangles fly at 8 m/s, 2 m a step, into walls of 2 cm whose near sides
/// are at 0.99 m and 4.99 m; a box flies by.
Scene two_walls() {
  Scene scene;
  scene.step = 0.25;
  scene.steps = 4;
  scene.shapes = {{"ball", Sphere{{0, 0, 0}, 0.25}},
                  {"wall", Box{{0.01, 1, 1}}},
                  {"cube", Shape(tests::make_box({0.25, 0.25, 0.25}))},
                  {"plate", Shape(tests::make_box({0.01, 1, 1}))},
                  {"box", Box{{0.25, 0.25, 0.25}}}};
  const SceneBody wall{
      .name = "wall", .shape = 1, .pose = at(1), .kind = BodyKind::Static, .path = {}};
  const SceneBody plate{
      .name = "plate", .shape = 3, .pose = at(5, 10), .kind = BodyKind::Static, .path = {}};
  scene.bodies = {flying("ball", 0, at(0)), wall, flying("cube", 2, at(0, 10)), plate,
                  flying("box", 4, at(0, 20))};
  return scene;
}

std::vector<EngineEntry> graze_and_still() {
  std::vector<EngineEntry> engines;
  engines.push_back({"graze", make_graze_engine()});
  engines.push_back({"still", make_motionless_engine("still")});
  return engines;
}

/// What is kept of each step and pair, by the name of the engine.
using Kept = std::map<std::pair<std::size_t, ScenePair>, std::map<std::string, AnswerRecord>>;

Kept compared(const Scene& scene, std::span<const EngineEntry> engines,
              const SceneComparisonSettings& settings, std::size_t* questions = nullptr) {
  Kept kept;
  compare_scene(scene, engines, settings, {.first = 0, .end = settings.steps + 1, .threads = 2},
                each_record<StepRecord>([&](const StepRecord& record) {
                  if (questions != nullptr) *questions += record.questions;
                  for (const SceneDifference& difference : record.differences) {
                    for (const AnswerRecord& answer : difference.answers)
                      kept[{record.place, difference.pair}][answer.engine] = answer;
                  }
                }));
  return kept;
}

TEST(SceneMotions, TimesAreThoseOfTheFormula) {
  const Scene scene = two_walls();
  const std::vector<EngineEntry> engines = graze_and_still();
  std::size_t questions = 0;
  const Kept kept =
      compared(scene, engines, {.steps = scene.steps, .ask = Ask::FirstContact}, &questions);
  // Of step 0 nothing; of each other one all pairs but that of the walls, which both rest.
  EXPECT_EQ(questions, 4u * 9u);
  // The ball enters the wall in step 1 and leaves it there; the cube meets the plate in step 3.
  ASSERT_EQ(kept.size(), 2u);
  const auto& ball = kept.at({1, {0, 1}});
  const auto& cube = kept.at({3, {2, 3}});
  const auto near = [](const AnswerRecord& answer, double time) {
    ASSERT_TRUE(answer.value) << answer.brief;
    EXPECT_NEAR(*answer.value, time, 1e-6) << answer.engine;
    EXPECT_EQ(answer.judgement.verdict, Verdict::Right) << answer.judgement.truth;
  };
  for (const char* name : {"world", "graze"}) {
    near(ball.at(name), (0.99 - 0.25) / 2);
    near(cube.at(name), (4.99 - 0.25 - 4) / 2);
  }
  for (const auto* pair : {&ball, &cube}) {
    const AnswerRecord& still = pair->at("still");
    EXPECT_EQ(still.brief, "free");
    EXPECT_TRUE(still.is_wrong());
    EXPECT_NE(still.judgement.truth.find(": missed"), std::string::npos) << still.judgement.truth;
  }
}

TEST(SceneMotions, YesOrNoAndAClearance) {
  const Scene scene = two_walls();
  const std::vector<EngineEntry> engines = graze_and_still();
  const Kept plain = compared(scene, engines, {.steps = scene.steps, .ask = Ask::Free});
  ASSERT_EQ(plain.size(), 2u);
  EXPECT_EQ(plain.at({1, {0, 1}}).at("graze").brief, "no");
  EXPECT_EQ(plain.at({1, {0, 1}}).at("still").brief, "yes");
  EXPECT_TRUE(plain.at({1, {0, 1}}).at("still").is_wrong());
  // Within half a metre the ball also leaves the wall in step 2, and the cube comes to the plate at
  // the end of step 2 and leaves it in step 3 for good.
  const Kept wide =
      compared(scene, engines, {.steps = scene.steps, .ask = Ask::FirstContact, .clearance = 0.8});
  EXPECT_TRUE(wide.contains({1, {0, 1}}));
  EXPECT_TRUE(wide.contains({2, {0, 1}}));
  EXPECT_TRUE(wide.contains({2, {2, 3}}));
  EXPECT_TRUE(wide.contains({3, {2, 3}}));
  for (const auto& [where, answers] : wide) {
    EXPECT_FALSE(answers.at("graze").is_wrong()) << answers.at("graze").judgement.truth;
    EXPECT_FALSE(answers.at("world").is_wrong()) << answers.at("world").judgement.truth;
  }
}

/// The world says what graze says of a pair alone, or one of the two is wrong.
TEST(SceneMotions, TheWorldIsHeldAgainstGraze) {
  const Scene scene = two_walls();
  std::vector<EngineEntry> engines;
  engines.push_back({"graze", make_motionless_engine("graze")});
  const Kept kept = compared(scene, engines, {.steps = scene.steps, .ask = Ask::FirstContact});
  ASSERT_EQ(kept.size(), 2u);
  for (const auto& [where, answers] : kept) {
    EXPECT_TRUE(answers.at("graze").is_wrong());
    EXPECT_TRUE(answers.at("world").is_wrong());
    EXPECT_NE(answers.at("world").judgement.truth.find("graze alone says free"), std::string::npos);
  }
}

/// All pairs, one by one, of bundled bodies of all kinds: the world lists no other, and the same.
TEST(SceneMotions, TheWorldSaysOfBundledScenesWhatEachPairSays) {
  std::vector<EngineEntry> engines;
  engines.push_back({"graze", make_graze_engine()});
  std::size_t met = 0;
  for (const char* name : {"fast", "shapes", "machine"}) {
    const Scene scene = read_scene(std::string(GRAZE_DATA_DIR "/scenes/") + name + ".json",
                                   {.mesh_folder = GRAZE_DATA_DIR "/meshes"});
    const std::size_t steps = std::string(name) == "machine" ? 2 : 12;
    for (const auto& [where, answers] :
         compared(scene, engines, {.steps = steps, .ask = Ask::FirstContact})) {
      const std::string place = std::string(name) + " step " + std::to_string(where.first);
      met += answers.at("world").brief != "free";
      EXPECT_EQ(answers.at("world").brief, answers.at("graze").brief) << place;
      EXPECT_FALSE(answers.at("world").is_wrong())
          << place << ": " << answers.at("world").judgement.truth;
      EXPECT_FALSE(answers.at("graze").is_wrong())
          << place << ": " << answers.at("graze").judgement.truth;
    }
  }
  EXPECT_GT(met, 10u);
}

/// Who repeats the case of a step gets the answer of the step.
TEST(SceneMotions, ACaseOfAStepSaysTheSame) {
  const Scene scene = two_walls();
  SceneComparisonSettings settings{.steps = scene.steps, .ask = Ask::FirstContact};
  const Case meshes = case_of(scene, {2, 3}, settings, {.from = 0.5, .to = 0.75});
  EXPECT_TRUE(std::holds_alternative<CaseMesh>(meshes.a));
  EXPECT_NEAR(*answer_case(meshes).low, (4.99 - 0.25 - 4) / 2, 1e-6);
  const Case shapes = case_of(scene, {0, 1}, settings, {.from = 0, .to = 0.25});
  EXPECT_NEAR(*answer_case(shapes).low, (0.99 - 0.25) / 2, 1e-6);
  EXPECT_FALSE(std::get<CaseBody>(*shapes.b).course);
  settings.ask = Ask::Any;
  EXPECT_FALSE(*answer_case(case_of(scene, {0, 1}, settings, {.from = 0, .to = 0.25})).says);
}

}  // namespace
}  // namespace graze::compare

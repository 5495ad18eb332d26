// The judge finds what is wrong, and bodies have the friction that they are given.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "samples/simulation/scenes/catalogue.h"
#include "samples/simulation/scenes/judgement.h"
#include "samples/simulation/scenes/parts.h"
#include "samples/simulation/scenes/rolling.h"

namespace graze::samples {
namespace {

TEST(SceneJudgement, SaysWhatDoesNotRest) {
  Scene scene = rolling_ball(Surface::Analytic);
  scene.steps = 20;
  const SceneReport report = run_scene(scene);
  EXPECT_TRUE(complaints(report, Outcome::Moves).empty());
  EXPECT_TRUE(complaints(report, Outcome::Shown).empty());
  const std::vector<std::string> found = complaints(report, Outcome::Rests);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NE(found[0].find("ball.rolls.shape: the drift at the end is "), std::string::npos);
  EXPECT_NE(found[1].find("the speed at the end"), std::string::npos);
}

TEST(SceneJudgement, SeesABodyThatIsThrownAndTheEnergyOfIt) {
  // Two boxes that begin halfway in each other, pushed apart as fast as the solver may.
  Scene scene{.name = "thrown", .bodies = {floor_of(Surface::Analytic)}, .steps = 30};
  scene.solver.push_speed = 100, scene.solver.relaxations = 0;
  for (const double z : {0.1, 0.2})
    scene.bodies.push_back({.name = "box", .shape = Box{{0.1, 0.1, 0.1}}, .pose = at({0, 0, z})});
  const SceneReport report = run_scene(scene);
  EXPECT_GT(report.energy, 0.01);
  EXPECT_GT(report.excess, 0.1);
  EXPECT_EQ(complaints(report, Outcome::Moves).size(), 2u);
}

TEST(SceneJudgement, CountsWhatIsNoNumberAsWorst) {
  SceneReport report{.name = "lost"};
  report.drift = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaints(report, Outcome::Rests).size(), 1u);
}

TEST(SceneCatalogue, KnowsScenesByTheirNames) {
  const CatalogueSettings settings{.data = GRAZE_DATA_DIR};
  const std::optional<Scene> found = find_scene("stairs.plank.mesh", settings);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->name, "stairs.plank.mesh");
  EXPECT_FALSE(find_scene("stairs", settings));
  std::vector<std::string> names;
  for (const Scene& scene : all_scenes(settings))
    names.push_back(scene.name);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST(SolverFriction, IsThatOfBothSurfaces) {
  // On a slope of 0.3 radians, whose tangent is 0.31, what has 0.2 slides as it must, and what has
  // 0.4 stays.
  constexpr double kSlope = 0.3, kSeconds = 0.5;
  Scene scene{.name = "slope", .bodies = {floor_of(Surface::Analytic)}, .steps = 75};
  const Pose tilt = at({0, 0, 0}, -kSlope, Eigen::Vector3d::UnitY());
  scene.bodies[0].pose = tilt * scene.bodies[0].pose;
  for (const double friction : {0.2, 0.4}) {
    scene.bodies.push_back({.name = friction < 0.3 ? "slides" : "stays",
                            .shape = Box{{0.2, 0.2, 0.05}},
                            .pose = tilt * at({0, friction < 0.3 ? 1.0 : -1.0, 0.05}),
                            .friction = friction * friction / 0.5});
  }
  SceneRun run(scene);
  const std::vector<RigidBody> before = run.bodies();
  for (int i = 0; i < scene.steps; ++i)
    run.step();
  const double way = (run.body("slides").at - before[1].at).norm();
  const double pull = 9.81 * (std::sin(kSlope) - 0.2 * std::cos(kSlope));
  EXPECT_NEAR(way, 0.5 * pull * kSeconds * kSeconds, 0.02 * way);
  EXPECT_LT((run.body("stays").at - before[2].at).norm(), 1e-3);
}

}  // namespace
}  // namespace graze::samples

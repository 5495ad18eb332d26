// The judge of placed shapes: proofs on both sides of the touch, errors of known size, and scenes
// with an engine that is wrong on purpose.

#include <graze/engine/compare/judge/bodies/shape_bodies.h>
#include <graze/engine/compare/judge/shape_judge.h>
#include <graze/engine/compare/run/poses/pose_source.h>
#include <graze/engine/compare/run/scene_comparison.h>
#include <graze/engine/scenes/read_scene.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>

#include "tests/compare/each_record.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::compare {
namespace {

std::vector<Shape> one_of_each_kind() {
  const std::vector<Eigen::Vector3d> corners = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                                {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  return {Sphere{{0, 0, 0}, 1},
          Box{{1, 1, 1}},
          Capsule{0.5, 0.5},
          Cylinder{1, 1},
          Cone{1, 1},
          Ellipsoid{{0, 0, 0}, {1, 1, 1}},
          ConvexHull(corners),
          HalfSpace{{-1, 0, 0}, -0.0},
          tests::make_box({1, 1, 1}),
          Plane{{-1, 0, 0}, 0}};
}

Pose at_x(double x, double z = 0) {
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Vector3d(x, 0, z);
  return pose;
}

/// The height at which a shape reaches furthest along x, one of them.
double height_of(const Shape& shape) {
  return shape.kind() == ShapeKind::Cone ? -1 : 0;
}

Judgement judged(const Shape& a, const Shape& b, double x, bool says, const char* engine) {
  const Pose pose_a = Pose::Identity();
  const Pose pose_b = at_x(x, height_of(a) - height_of(b));
  return ShapeJudge({a, pose_a}, {b, pose_b}).judge(says, {engine, ""});
}

/// How far along x a shape reaches, and so where two of them touch.
double reach_of(const Shape& shape) {
  return shape.kind() == ShapeKind::HalfSpace ? 0 : support_along(shape, at_x(0), {1, 0, 0});
}

TEST(ShapeJudge, EveryPairIsProvedOnBothSidesOfTheTouch) {
  const std::vector<Shape> shapes = one_of_each_kind();
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      // Half-spaces here open towards +x: as B they are what A reaches into.
      if (a.kind() == ShapeKind::HalfSpace) continue;
      if (a.kind() == ShapeKind::Plane && b.kind() == a.kind()) continue;  // they pass each other
      SCOPED_TRACE(std::string(name_of(a.kind())) + "/" + name_of(b.kind()));
      const double touch = reach_of(a) + reach_of(b);
      for (const double beyond : {0.25, 1e-3, 1e-8}) {
        const Judgement gap = judged(a, b, touch + beyond, true, "fcl");
        EXPECT_EQ(gap.verdict, Verdict::Wrong) << beyond;
        EXPECT_EQ(gap.error_class, beyond > 1e-5 ? ErrorClass::Real : gap.error_class);
        EXPECT_EQ(judged(a, b, touch + beyond, false, "fcl").verdict, Verdict::Right) << beyond;
        const Judgement hit = judged(a, b, touch - beyond, false, "fcl");
        EXPECT_EQ(hit.verdict, Verdict::Wrong) << -beyond;
        EXPECT_EQ(judged(a, b, touch - beyond, true, "fcl").verdict, Verdict::Right) << -beyond;
      }
    }
  }
}

TEST(ShapeJudge, ErrorsHaveTheirSizeAndClass) {
  const Shape cone = Cone{1, 1};
  const Shape pill = Capsule{0.5, 0.5};
  const Judgement far = judged(cone, pill, 1.75, true, "fcl");
  EXPECT_EQ(far.error_class, ErrorClass::Real);
  EXPECT_NEAR(far.error, 0.25, 1e-8);
  const Shape ball = Sphere{{0, 0, 0}, 1};
  const Judgement near = judged(ball, Shape(Cylinder{1, 1}), 2 + 1e-7, true, "fcl");
  EXPECT_EQ(near.verdict, Verdict::Wrong);
  EXPECT_EQ(near.error_class, ErrorClass::Touching);
  EXPECT_NEAR(near.error, 1e-7, 1e-9);
}

/// Law 11: graze may call a hit what its own tolerance cannot tell from one, but nothing more.
TEST(ShapeJudge, GrazeIsHeldToItsOwnTolerance) {
  const Shape drum = Cylinder{1, 1};
  const Shape pill = Capsule{0.5, 0.5};
  EXPECT_EQ(judged(drum, pill, 1.5 + 1e-11, true, "graze").verdict, Verdict::Right);
  EXPECT_EQ(judged(drum, pill, 1.5 + 1e-8, true, "graze").verdict, Verdict::Wrong);
  EXPECT_EQ(judged(drum, pill, 1.5 - 1e-8, false, "graze").verdict, Verdict::Wrong);
  const Shape ball = Sphere{{0, 0, 0}, 1};
  EXPECT_EQ(judged(ball, ball, 2 + 0x1p-51, true, "graze").verdict, Verdict::Wrong);  // exact
  EXPECT_EQ(judged(ball, ball, 2, false, "graze").verdict, Verdict::Wrong);
}

/// In a hollow no plane parts the two, and nothing is claimed.
TEST(ShapeJudge, WhatIsNotProvedIsNotJudged) {
  const Shape ring = tests::make_torus(2, 0.5, 24, 12);
  EXPECT_EQ(judged(ring, Shape(Capsule{0.25, 0.25}), 0, true, "fcl").verdict, Verdict::NotJudged);
  EXPECT_EQ(judged(ring, Shape(Sphere{{0, 0, 0}, 0.25}), 0, true, "fcl").verdict, Verdict::Wrong);
}

/// Says that nothing ever touches.
class Blind : public Engine {
  class Nothing : public LoadedShapes {
    std::optional<bool> intersects(std::size_t, const Pose&, std::size_t,
                                   const Pose&) const override {
      return false;
    }
  };

 public:
  CaseWitness name() const override { return {"blind", ""}; }
  std::unique_ptr<LoadedPair> load(const Mesh&, const Mesh&) const override { return nullptr; }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape>) const override {
    return std::make_unique<Nothing>();
  }
};

TEST(SceneComparison, FindsWhoIsWrongAtEachStep) {
  const Scene scene = read_scene(GRAZE_DATA_DIR "/scenes/shapes.json");
  std::vector<EngineEntry> engines = all_engines();
  engines.push_back({"blind", std::make_unique<Blind>()});
  std::size_t touching = 0;
  std::size_t overlooked = 0;
  const auto on_answer = [&](const AnswerRecord& answer, std::size_t step) {
    touching += answer.engine == "world" && answer.brief == "yes";
    if (answer.engine == "world" || answer.engine == "graze") {
      EXPECT_FALSE(answer.is_wrong()) << step;
    }
    if (answer.engine != "blind" || !answer.is_wrong()) return;
    ++overlooked;
    EXPECT_EQ(answer.judgement.truth.substr(0, 3), "hit");
  };
  constexpr std::size_t kFirst = 3;  // of what a record has before it nothing is asked
  std::size_t steps = 0;
  compare_scene(scene, engines, {.steps = scene.steps},
                {.first = kFirst, .end = scene.steps + 1, .threads = 3},
                each_record<StepRecord>([&](const StepRecord& record) {
                  EXPECT_EQ(record.place, kFirst + steps);
                  ++steps;
                  EXPECT_EQ(record.time, static_cast<double>(record.place) * scene.step);
                  for (const SceneDifference& difference : record.differences) {
                    for (const AnswerRecord& answer : difference.answers)
                      on_answer(answer, record.place);
                  }
                }));
  EXPECT_EQ(steps, scene.steps + 1 - kFirst);
  EXPECT_GT(touching, 100u);
  EXPECT_GT(overlooked, touching * 9 / 10);
  EXPECT_LE(overlooked, touching);
}

/// Looks for pairs itself, as graze has them, but for the last one of many, which it loses.
class LosesTheLast : public Engine {
  class Shapes : public LoadedShapes {
   public:
    explicit Shapes(std::unique_ptr<LoadedShapes> inner) : inner_(std::move(inner)) {}
    std::optional<bool> intersects(std::size_t a, const Pose& pose_a, std::size_t b,
                                   const Pose& pose_b) const override {
      return inner_->intersects(a, pose_a, b, pose_b);
    }
    ShapesAnswer intersect_all(
        std::span<const PlacedShape> bodies,
        std::span<const std::pair<std::size_t, std::size_t>> pairs) const override {
      ShapesAnswer all = inner_->intersect_all(bodies, pairs);
      if (pairs.size() > 1) all.pairs.back().says = false;
      return all;
    }

   private:
    std::unique_ptr<LoadedShapes> inner_;
  };

 public:
  explicit LosesTheLast(bool answers_scenes) : answers_scenes_(answers_scenes) {}
  CaseWitness name() const override { return {"loses", ""}; }
  bool answers_scenes() const override { return answers_scenes_; }
  std::unique_ptr<LoadedPair> load(const Mesh&, const Mesh&) const override { return nullptr; }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return std::make_unique<Shapes>(make_graze_engine()->load_shapes(shapes));
  }
  std::unique_ptr<Engine> alone() const override {
    return std::make_unique<LosesTheLast>(answers_scenes_);
  }

 private:
  bool answers_scenes_;
};

/// A pair alone is another question than the pair among others: an engine that looks for pairs is
/// asked all of them again.
TEST(SceneComparison, WhatABroadPhaseLosesIsConfirmedAmongAll) {
  const Scene scene = read_scene(GRAZE_DATA_DIR "/scenes/shapes.json");
  for (const bool answers_scenes : {true, false}) {
    std::vector<EngineEntry> engines;
    engines.push_back({"graze", make_graze_engine()});
    engines.push_back({"loses", std::make_unique<LosesTheLast>(answers_scenes)});
    std::map<Verdict, std::size_t> verdicts;
    compare_scene(scene, engines, {.steps = scene.steps}, {.end = scene.steps + 1, .threads = 2},
                  each_record<StepRecord>([&](const StepRecord& record) {
                    for (const SceneDifference& difference : record.differences)
                      for (const AnswerRecord& answer : difference.answers)
                        if (answer.engine == "loses") ++verdicts[answer.judgement.verdict];
                  }));
    EXPECT_GT(verdicts[answers_scenes ? Verdict::Wrong : Verdict::NotConfirmed], 0u);
    EXPECT_EQ(verdicts[answers_scenes ? Verdict::NotConfirmed : Verdict::Wrong], 0u);
  }
}

/// FCL's own walks over all bodies: whatever finds the pairs, the same ones meet.
TEST(SceneComparison, FclsManagersSayWhatFclSaysOfEachPair) {
  const Scene scene = read_scene(GRAZE_DATA_DIR "/scenes/shapes.json");
  std::vector<EngineEntry> engines;
  for (EngineEntry& entry : all_engines())
    if (entry.name == "graze" || entry.name == "fcl") engines.push_back(std::move(entry));
  for (EngineEntry& entry : scene_engines())
    engines.push_back(std::move(entry));
  if (engines[1].engine == nullptr) GTEST_SKIP() << "without FCL";
  std::map<std::string, std::size_t> answers;
  std::set<std::string> digests;
  const auto is_of_fcl = [](const std::string& name) {
    return name.starts_with("fcl") && !name.starts_with("fcl-tree");
  };
  compare_scene(scene, engines, {.steps = scene.steps}, {.end = scene.steps + 1, .threads = 2},
                each_record<StepRecord>([&](const StepRecord& record) {
                  digests.clear();
                  for (const StepAnswers& each : record.engines) {
                    answers[each.engine] += each.answers;
                    if (is_of_fcl(each.engine)) digests.insert(each.digest);
                  }
                  EXPECT_EQ(digests.size(), 1u) << record.place;
                  for (const SceneDifference& difference : record.differences)
                    for (const AnswerRecord& answer : difference.answers)
                      EXPECT_NE(answer.judgement.error_class, ErrorClass::EngineError)
                          << answer.engine << ": " << answer.judgement.truth;
                }));
  EXPECT_EQ(answers.size(), 10u);
  for (const auto& [engine, count] : answers) {
    if (is_of_fcl(engine)) {
      EXPECT_EQ(count, answers["fcl"]) << engine;
    }
  }
  EXPECT_GT(answers["fcl"], 1000u);
  EXPECT_LT(answers["fcl-tree"], answers["fcl"]) << "which takes no half-space";
  EXPECT_GT(answers["fcl-tree"], 900u);
  EXPECT_EQ(answers["fcl-tree-array"], answers["fcl-tree"]);
}

// Turned and at all distances: what is half a millimetre apart or deep is beyond doubt. ODE's
// meshes have one side, and its hulls miss them.
TEST(Peers, ShapesOfOthersAreTheShapesThatWereMeant) {
  const Mesh proxy = tests::make_box({1, 1, 1});
  const std::vector<Pose> poses_a = random_poses({proxy}, proxy, 30, 5);
  const std::vector<Pose> poses_b = random_poses({proxy}, proxy, 30, 6);
  std::vector<Shape> shapes = one_of_each_kind();
  shapes[0] = Sphere{{0.5, 0, 0.25}, 0.75};
  shapes[4] = Cone{1, 0.75};
  shapes[6] = ConvexHull(std::vector<Eigen::Vector3d>{
      {0, 0, 0}, {1.5, 0, 0}, {1.5, 1, 0}, {0, 1.25, 0}, {0.25, 0.25, 1.75}});
  shapes[7] = HalfSpace{{-1, 2, 2}, -0.25};
  std::size_t answers = 0;
  std::size_t hits = 0;
  const std::vector<EngineEntry> engines = all_engines();
  for (const EngineEntry& entry : engines) {
    if (entry.name == "fcl" || entry.engine == nullptr) continue;  // tests/crosscheck/ has FCL
    const std::unique_ptr<LoadedShapes> loaded = entry.engine->load_shapes(shapes);
    ASSERT_NE(loaded, nullptr) << entry.name;
    for (std::size_t at = 0; at < 30 * 81; ++at) {
      const Shape& a = shapes[at % 9];
      const Shape& b = shapes[at / 9 % 9];
      const Pose& pose_a = poses_a[at / 81];
      const Pose& pose_b = poses_b[at / 81];
      const std::optional<bool> says = loaded->intersects(at % 9, pose_a, at / 9 % 9, pose_b);
      if (!says) continue;
      ++answers;
      const auto has = [&](ShapeKind kind) { return a.kind() == kind || b.kind() == kind; };
      const bool is_behind =
          has(ShapeKind::HalfSpace) && (has(ShapeKind::Mesh) || has(ShapeKind::ConvexHull));
      if (!*says && (is_behind || (entry.name == "ode" && has(ShapeKind::Mesh)))) continue;
      const Judgement judgement =
          ShapeJudge({a, pose_a}, {b, pose_b}).judge(*says, {entry.name, ""});
      hits += judgement.truth.substr(0, 3) == "hit";
      EXPECT_FALSE(judgement.verdict == Verdict::Wrong && judgement.error > 5e-4)
          << entry.name << ": " << name_of(a.kind()) << "/" << name_of(b.kind()) << " in pose "
          << at / 81 << " says " << *says << ", " << judgement.truth;
    }
  }
  EXPECT_GT(answers, 2000u);
  EXPECT_GT(hits, answers / 8);
  EXPECT_LT(hits, answers * 7 / 8);
}

}  // namespace
}  // namespace graze::compare

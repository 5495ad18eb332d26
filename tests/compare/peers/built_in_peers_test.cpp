// The engines of this project's adaptors as `graze compare` asks them: from many threads, as from
// one; about what was meant, bit for bit.

#include <graze/engine/cases/motion_case.h>
#include <graze/engine/cases/read/read_parts.h>
#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/compare/peers/process/protocol.h>
#include <graze/engine/compare/run/case_comparison.h>
#include <graze/engine/compare/run/poses/pose_source.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/hull_data.h>
#include <graze/narrowphase/convex/core/hull.h>
#include <gtest/gtest.h>
#include <cmath>
#include <map>

#include "tests/compare/each_record.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_source.h"

namespace graze::compare {
namespace {

/// Meshes of a thousand triangles, another in each case, in poses from far apart to deep.
CaseJob many_meshes(std::size_t count) {
  CaseJob job;
  const Mesh proxy = tests::make_torus(1, 0.3, 25, 20);
  const std::vector<Pose> poses = random_poses({proxy}, proxy, count, 3);
  for (std::size_t i = 0; i < count; ++i) {
    const Mesh a = tests::make_torus(1, 0.3 + 1e-4 * static_cast<double>(i), 25, 20);
    const Mesh b = tests::make_torus(0.8, 0.25, 25, 20);
    Case query = to_case({a}, {b, poses[i]}, true);
    query.ask = i % 2 == 0 ? Ask::Any : Ask::Contacts;
    query.answer.reset();
    job.cases.push_back({"case" + std::to_string(i), std::move(query)});
  }
  return job;
}

/// Of each case what each engine said, and how it was judged.
using Said = std::map<std::pair<std::size_t, std::string>, std::pair<std::string, std::string>>;

Said compare_all(const CaseJob& job, std::size_t threads, std::span<const EngineEntry> engines) {
  Said said;
  compare_cases(
      job, engines, {.end = job.cases.size(), .threads = threads},
      each_record<PlaceRecord>([&](const PlaceRecord& record) {
        for (const AnswerRecord& answer : record.answers) {
          said[{record.place, answer.engine}] = {answer.digest, name_of(answer.judgement.verdict)};
          EXPECT_NE(answer.judgement.verdict, Verdict::NotConfirmed) << answer.engine;
          if (!answer.is_wrong()) continue;
          EXPECT_NE(answer.judgement.error_class, ErrorClass::EngineError)
              << answer.engine << " in case " << record.place << ": " << answer.judgement.truth;
        }
      }));
  return said;
}

void expect_same_on_threads(std::size_t count, std::span<const EngineEntry> engines) {
  const Said alone = compare_all(many_meshes(count), 1, engines);
  EXPECT_GE(alone.size(), count);
  EXPECT_EQ(compare_all(many_meshes(count), 8, engines), alone);
}

/// One of the engines besides graze: where it was not built in its tests are skipped, and say so.
class BuiltInPeers : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    for (EngineEntry& entry : all_engines()) {
      if (entry.name == GetParam()) engine_.push_back(std::move(entry));
    }
    ASSERT_EQ(engine_.size(), 1u) << "no such engine is known";
    if (engine_[0].engine == nullptr)
      GTEST_SKIP() << GetParam() << " was not found when this was built: nothing is tested of it";
  }

  std::span<const EngineEntry> engines() const { return engine_; }
  const Engine& engine() const { return *engine_[0].engine; }

 private:
  std::vector<EngineEntry> engine_;
};

INSTANTIATE_TEST_SUITE_P(Each, BuiltInPeers, testing::Values("fcl", "bullet", "ode", "coal"),
                         [](const auto& peer) { return std::string(peer.param); });

TEST(KnownPeers, AreThoseThatAreTested) {
  std::string names;
  for (const EngineEntry& entry : all_engines())
    names += entry.name + " ";
  EXPECT_EQ(names, "graze fcl bullet ode coal fcl-advancement ");
}

// Eight threads in one process of ODE's crashed, or were told of hits that it does not find.
TEST_P(BuiltInPeers, SaysTheSameOnManyThreads) {
  expect_same_on_threads(24, engines());
}

TEST(BuiltInPeersSlow, SayTheSameOnManyThreads) {
  expect_same_on_threads(400, all_engines());
}

/// Together with other questions as alone; and about what was meant: no answer is plainly wrong.
TEST_P(BuiltInPeers, AnswersEveryQuestionThatItKnows) {
  const Mesh torus = tests::make_torus(1, 0.3, 12, 8);
  Pose pose = Pose::Identity();
  pose.translation() << 1.25, 0.125, -0.0;
  EXPECT_FALSE(engine().name().version.empty());
  std::size_t answers = 0;
  for (const Ask what : {Ask::Any, Ask::Pairs, Ask::Distance, Ask::Within, Ask::Contacts}) {
    Case query = to_case({torus}, {torus, pose}, true);
    query.ask = what;
    query.settings.clearance = 0.25;
    query.answer.reset();
    const std::optional<CaseAnswer> answer = ask(engine(), query);
    if (!answer) continue;
    ++answers;
    const std::unique_ptr<Engine> alone = engine().alone();
    ASSERT_NE(alone, nullptr);
    EXPECT_EQ(alone->alone(), nullptr);
    const std::optional<CaseAnswer> again = ask(*alone, query);
    ASSERT_TRUE(again);
    EXPECT_TRUE(is_same(*answer, *again)) << name_of(what);
    const Judgement judgement = Judge(query).judge(*answer, engine().name());
    const bool is_plainly_wrong =
        judgement.verdict == Verdict::Wrong && judgement.error_class == ErrorClass::Real;
    EXPECT_FALSE(is_plainly_wrong) << name_of(what) << ": " << judgement.truth;
  }
  EXPECT_GE(answers, 2u);
}

/// Balls and boxes whose distance and depth are known by hand, by each question that the engine
/// knows: what a user of it would see, for no proof takes part.
TEST_P(BuiltInPeers, KnowsDistancesAndContactsOfShapes) {
  const std::vector<std::pair<Shape, Shape>> pairs = {
      {Sphere{{0, 0, 0}, 1}, Sphere{{0, 0, 0}, 0.5}},
      {Box{{1, 1, 1}}, Box{{0.5, 0.25, 0.25}}},
      {Capsule{1, 0.5}, Sphere{{0, 0, 0}, 0.5}}};
  std::size_t distances = 0;
  std::size_t contacts = 0;
  for (const auto& [a, b] : pairs) {
    for (const double gap : {0.25, -0.25}) {
      Pose pose = Pose::Identity();
      pose.translation().x() = 1.5 + gap;
      Case query = to_case({a, Pose::Identity()}, {b, pose}, distance({a}, {b, pose}));
      query.answer.reset();
      if (const std::optional<CaseAnswer> answer = ask(engine(), query)) {
        ++distances;
        EXPECT_NEAR(std::max(*answer->distance, 0.0), std::max(gap, 0.0), 1e-6);
      }
      query.ask = Ask::Within;
      for (const double clearance : {0.125, 0.5}) {
        query.settings.clearance = clearance;
        const std::optional<CaseAnswer> within = ask(engine(), query);
        EXPECT_TRUE(!within || *within->says == (gap < clearance));
      }
      query.ask = Ask::Contacts;
      const std::optional<CaseAnswer> answer = ask(engine(), query);
      if (!answer) continue;
      ++contacts;
      EXPECT_EQ(answer->manifold->empty(), gap > 0);
      for (const CaseShapeContact& contact : *answer->manifold) {
        EXPECT_NEAR(contact.depth, -gap, 1e-5);
        EXPECT_NEAR(contact.normal.x(), 1, 1e-5) << "from A to B";
      }
    }
  }
  EXPECT_EQ(contacts, 6u);
  EXPECT_EQ(distances, std::string(GetParam()) == "ode" ? 0u : 6u);
}

Shape read_back(const Shape& shape) {
  const std::string name = "memory";
  const cases::JsonValue tree = cases::parse_json(*shape_text(shape), name);
  return read_shape(cases::JsonCursor(tree, name));
}

bool is_bit_equal(double a, double b) {
  return a == b && std::signbit(a) == std::signbit(b);
}

TEST(PeerProtocol, NumbersComeBackBitForBit) {
  for (const double value : {0.0, -0.0, 1e22, 0x1p+60, -0x1p+63, 0x1p+64, 5e-324, -1.7e308, 0.1}) {
    const Pose pose = [&] {
      Pose there = Pose::Identity();
      there.translation().y() = value;
      return there;
    }();
    const std::string text =
        "{" + question_text({Ask::Within, {.clearance = 0.1}}, Pose::Identity(), pose) + "}";
    const std::string name = "memory";
    const cases::JsonValue tree = cases::parse_json(text, name);
    const cases::JsonCursor root(tree, name);
    const cases::JsonCursor there = root.member("pose_b");
    EXPECT_TRUE(is_bit_equal(there.item(7).number(), value)) << value;
    EXPECT_EQ(root.member("settings").member("clearance").number(), 0.1);
  }
}

TEST(PeerProtocol, MotionsComeBackBitForBit) {
  const RigidCourse course{
      .centre = {0.1, -0.0, 1e-300}, .shift = {1e22, 5e-324, 0.3}, .axis = {1, 2, 3}, .angle = 0.7};
  const Question question{Ask::Free, {.clearance = 0.1, .tolerance = 0.3}, std::nullopt, course};
  const std::string text = "{" + question_text(question, Pose::Identity(), Pose::Identity()) + "}";
  const std::string name = "memory";
  const cases::JsonValue tree = cases::parse_json(text, name);
  const cases::JsonCursor root(tree, name);
  EXPECT_FALSE(root.has("motion_a"));
  const RigidCourse back = cases::read_course(root.member("motion_b"));
  EXPECT_EQ(back.centre, course.centre);
  EXPECT_TRUE(std::signbit(back.centre.y()));
  EXPECT_EQ(back.shift, course.shift);
  EXPECT_EQ(back.axis, course.axis);
  EXPECT_EQ(back.angle, course.angle);
  EXPECT_EQ(root.member("settings").member("tolerance").number(), 0.3);
}

// Built again from what they say of themselves, hulls and half-spaces may be others by an ulp.
TEST(PeerProtocol, HullsAndHalfSpacesComeBackBitForBit) {
  RandomSource source(7);
  const auto number = [&](double size) { return source.uniform(-size / 2, size / 2); };
  constexpr int kShapes = 300;
  int hulls = 0;
  int half_spaces = 0;
  for (int i = 0; i < kShapes; ++i) {
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k < 12; ++k)
      points.emplace_back(number(2) + 0.3, number(1) - 7, number(5));
    const Shape hull = ConvexHull(points);
    if (shape_text(hull)) {
      ++hulls;
      const auto& a = data_of(*hull.as<ConvexHull>());
      const Shape back = read_back(hull);
      const auto& b = data_of(*back.as<ConvexHull>());
      ASSERT_EQ(a.corners.size(), b.corners.size());
      for (std::size_t k = 0; k < a.corners.size(); ++k) {
        EXPECT_EQ(a.corners[k].x, b.corners[k].x);
        EXPECT_EQ(a.corners[k].y, b.corners[k].y);
        EXPECT_EQ(a.corners[k].z, b.corners[k].z);
      }
      EXPECT_EQ(a.middle.x, b.middle.x);
      EXPECT_EQ(a.faces.size(), b.faces.size());
    }
    const Shape plane = HalfSpace{{number(2), number(2), number(2)}, number(3)};
    if (!shape_text(plane)) continue;
    ++half_spaces;
    const Shape back = read_back(plane);
    EXPECT_EQ(back.as<HalfSpace>()->normal, plane.as<HalfSpace>()->normal);
    EXPECT_EQ(back.as<HalfSpace>()->offset, plane.as<HalfSpace>()->offset);
  }
  EXPECT_GT(hulls, kShapes * 9 / 10) << "what does not come back is not asked about";
  EXPECT_GT(half_spaces, kShapes * 9 / 10);
}

}  // namespace
}  // namespace graze::compare

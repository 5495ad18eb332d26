// Engines of a user's own: the clients in samples/engines, and commands that start none.

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/run/comparison.h>
#include <gtest/gtest.h>
#include <cstdio>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/compare/each_record.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::compare {
namespace {

const std::string kEngines = GRAZE_ENGINE_SAMPLES;

/// Each engine's answer to the question in each pose of B, which goes past A.
std::vector<std::vector<AnswerRecord>> answers(std::vector<EngineEntry> engines, Ask ask,
                                               const CaseShape& a, const CaseShape& b) {
  ComparisonJob job{.a = a, .b = b, .poses_b = nullptr, .question = {ask, {}}};
  std::vector<Pose> poses;
  for (int i = 0; i < 12; ++i) {
    Pose pose = Pose::Identity();
    pose.translation() = Eigen::Vector3d(0.15 * i, 0.03, 0.01);
    poses.push_back(pose);
  }
  job.poses_b = pose_list(poses);
  std::vector<std::vector<AnswerRecord>> all(poses.size());
  run_comparison(job, engines, {.end = job.places(), .threads = 2},
                 each_record<PlaceRecord>(
                     [&](const PlaceRecord& record) { all[record.place] = record.answers; }));
  return all;
}

/// Of a box that goes past a torus.
std::vector<std::vector<AnswerRecord>> answers(std::vector<EngineEntry> engines, Ask ask) {
  return answers(std::move(engines), ask,
                 CaseMesh(tests::make_torus(1, 0.25, 10, 8), Pose::Identity()),
                 CaseMesh(tests::make_box({0.2, 0.2, 0.2}), Pose::Identity()));
}

std::vector<EngineEntry> graze_and(EngineEntry other) {
  std::vector<EngineEntry> engines;
  engines.push_back({"graze", make_graze_engine()});
  engines.push_back(std::move(other));
  return engines;
}

TEST(UsersEngine, OfBoxesAloneIsWrongInTheTorussHole) {
  EngineEntry boxes = start_engine("python3 '" + kEngines + "/boxes.py'");
  EXPECT_EQ(boxes.name, "boxes");
  EXPECT_TRUE(boxes.is_users_own);
  EXPECT_EQ(boxes.engine->name().version, "1");
  const auto all = answers(graze_and(std::move(boxes)), Ask::Any);
  std::size_t wrong = 0;
  for (const std::vector<AnswerRecord>& answer : all) {
    ASSERT_EQ(answer.size(), 2u);
    EXPECT_FALSE(answer[0].is_wrong()) << "graze";
    wrong += answer[1].is_wrong();
  }
  EXPECT_TRUE(all.front()[1].is_wrong()) << "in the middle of the hole";
  EXPECT_EQ(all.front()[1].judgement.error_class, ErrorClass::Real);
  EXPECT_FALSE(all.back()[1].is_wrong()) << "apart";
  EXPECT_LT(wrong, all.size());
}

/// The client in Python knows shapes, too: balls and boxes, here, and no others.
TEST(UsersEngine, OfBoxesIsWrongWhereABallIsInACorner) {
  const std::string command = "python3 '" + kEngines + "/boxes.py'";
  const CaseBody box(Box{{0.5, 0.5, 0.5}}, Pose::Identity());
  Pose corner = Pose::Identity();
  corner.translation() = Eigen::Vector3d(0, 0.87, 0.87);  // the ball misses the edge by 0.03
  const auto all = answers(graze_and(start_engine(command)), Ask::Any, box,
                           CaseBody(Sphere{corner.translation(), 0.5}, Pose::Identity()));
  std::size_t wrong = 0;
  for (const std::vector<AnswerRecord>& answer : all) {
    ASSERT_EQ(answer.size(), 2u);
    EXPECT_FALSE(answer[0].is_wrong());
    wrong += answer[1].is_wrong();
    EXPECT_EQ(answer[1].judgement.verdict == Verdict::NotConfirmed, false);
  }
  EXPECT_GT(wrong, 2u);
  EXPECT_FALSE(all.back()[1].is_wrong()) << "apart";
  for (const auto& answer : answers(graze_and(start_engine(command)), Ask::Any, box,
                                    CaseBody(Cone{0.5, 0.5}, Pose::Identity())))
    EXPECT_EQ(answer.size(), 1u) << "it knows no cones";
  for (const auto& answer : answers(graze_and(start_engine(command)), Ask::Distance, box, box))
    EXPECT_EQ(answer.size(), 1u) << "nor distances";
}

TEST(UsersEngine, IsNotAskedWhatItDoesNotKnow) {
  const auto all =
      answers(graze_and(start_engine("python3 '" + kEngines + "/boxes.py'")), Ask::Distance);
  for (const std::vector<AnswerRecord>& answer : all)
    EXPECT_EQ(answer.size(), 1u);
}

#ifdef GRAZE_FCL_ENGINE
TEST(UsersEngine, OfFclSaysWhatFclSays) {
  for (const Ask ask : {Ask::Any, Ask::Distance}) {
    std::vector<EngineEntry> engines = graze_and(start_engine(GRAZE_FCL_ENGINE));
    EXPECT_EQ(engines.back().name, "my-fcl");
    for (EngineEntry& entry : all_engines())
      if (entry.name == "fcl") engines.push_back(std::move(entry));
    ASSERT_EQ(engines.size(), 3u);
    for (const std::vector<AnswerRecord>& answer : answers(std::move(engines), ask)) {
      ASSERT_EQ(answer.size(), 3u);
      EXPECT_EQ(answer[1].brief, answer[2].brief) << name_of(ask);
      EXPECT_FALSE(answer[1].is_wrong());
      EXPECT_GT(answer[1].time, 0);
    }
  }
}
#endif

#ifdef GRAZE_FCL_ENGINE
/// The client's page knows shapes as the adaptor does: whatever their kinds, both say the same.
TEST(UsersEngine, OfFclSaysWhatFclSaysOfShapes) {
  const std::vector<Shape> shapes = {
      Sphere{{0.25, 0, 0}, 0.5}, Box{{0.5, 0.25, 0.75}}, Capsule{0.25, 0.5},
      Cylinder{0.5, 0.25},       Cone{0.5, 0.5},         Ellipsoid{{0, 0.125, 0}, {0.5, 1, 0.25}}};
  for (const Ask ask : {Ask::Any, Ask::Distance, Ask::Contacts}) {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      std::vector<EngineEntry> engines = graze_and(start_engine(GRAZE_FCL_ENGINE));
      for (EngineEntry& entry : all_engines())
        if (entry.name == "fcl") engines.push_back(std::move(entry));
      const CaseBody a(shapes[i], Pose::Identity());
      const CaseBody b(shapes[(i + 1) % shapes.size()], Pose::Identity());
      for (const std::vector<AnswerRecord>& answer : answers(std::move(engines), ask, a, b)) {
        ASSERT_EQ(answer.size(), 3u);
        EXPECT_EQ(answer[1].brief, answer[2].brief) << name_of(ask) << i;
        EXPECT_EQ(answer[1].value, answer[2].value) << name_of(ask) << i;
      }
    }
  }
}
#endif

#ifdef GRAZE_PYTHON_FCL
/// The page that wraps python-fcl, on a stand-in for that package whose answers are FCL's: it says
/// what FCL says, of meshes and of all shapes that it knows.
TEST(UsersEngine, OfPythonFclSaysWhatFclSays) {
  const std::vector<CaseShape> known = {
      CaseMesh(tests::make_torus(1, 0.25, 10, 8), Pose::Identity()),
      CaseMesh(tests::make_box({0.2, 0.2, 0.2}), Pose::Identity()),
      CaseBody(Sphere{{0.25, 0, 0}, 0.5}, Pose::Identity()),
      CaseBody(Box{{0.5, 0.25, 0.75}}, Pose::Identity()),
      CaseBody(Capsule{0.25, 0.5}, Pose::Identity()),
      CaseBody(Cylinder{0.5, 0.25}, Pose::Identity()),
      CaseBody(Cone{0.5, 0.5}, Pose::Identity()),
      CaseBody(Ellipsoid{{0, 0.125, 0}, {0.5, 1, 0.25}}, Pose::Identity())};
  for (const Ask ask : {Ask::Any, Ask::Distance}) {
    for (std::size_t i = 0; i + 1 < known.size(); ++i) {
      if (i == 1) continue;  // a mesh and a shape
      std::vector<EngineEntry> engines = graze_and(start_engine(GRAZE_PYTHON_FCL));
      EXPECT_EQ(engines.back().name, "python-fcl");
      for (EngineEntry& entry : all_engines())
        if (entry.name == "fcl") engines.push_back(std::move(entry));
      std::size_t touching = 0;
      for (const std::vector<AnswerRecord>& answer :
           answers(std::move(engines), ask, known[i], known[i + 1])) {
        ASSERT_EQ(answer.size(), 3u);
        EXPECT_EQ(answer[1].brief, answer[2].brief) << name_of(ask) << i;
        EXPECT_EQ(answer[1].value, answer[2].value) << name_of(ask) << i;
        touching += answer[1].brief == "yes" || answer[1].value.value_or(1) <= 0;
      }
      EXPECT_GT(touching, 0u);
      EXPECT_LT(touching, 12u);
    }
  }
}

TEST(UsersEngine, OfPythonFclRefusesWhatThatHasNot) {
  const CaseBody box(Box{{0.5, 0.5, 0.5}}, Pose::Identity());
  const CaseBody flat(HalfSpace{{0, 0, 1}, 0}, Pose::Identity());
  for (const auto& answer : answers(graze_and(start_engine(GRAZE_PYTHON_FCL)), Ask::Any, box, flat))
    EXPECT_EQ(answer.size(), 1u);
}
#endif

/// What a program prints.
std::string printed_by(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  if (pipe == nullptr) return text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
    text += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return text;
}

/// "passed, failed, refused" of the row of a class.
std::vector<int> row_of(const std::string& table, const std::string& kind) {
  std::istringstream words(table.substr(table.find(" " + kind + " ") + kind.size() + 1));
  std::vector<int> row(3, -1);
  for (int& each : row)
    words >> each;
  return row;
}

TEST(HardCaseReaders, NeedNoGrazeAndCountEveryCase) {
  const std::string cases = " '" GRAZE_DATA_DIR "/hard_cases' 2>/dev/null";
  const std::string boxes = printed_by("python3 '" + kEngines + "/hard_cases.py'" + cases);
  EXPECT_EQ(row_of(boxes, "coplanar"), (std::vector{5, 0, 0})) << boxes;
  EXPECT_EQ(row_of(boxes, "shapes")[0], 0) << "it knows triangles alone";
  EXPECT_GT(row_of(boxes, "triangles")[1], 0) << "what boxes cannot tell apart";
#ifdef GRAZE_FCL_HARD_CASES
  const std::string fcl = printed_by(std::string("'") + GRAZE_FCL_HARD_CASES + "'" + cases);
  EXPECT_GT(row_of(fcl, "all")[0], row_of(boxes, "all")[0]) << fcl;
  const auto sum = [](const std::vector<int>& row) { return row[0] + row[1] + row[2]; };
  EXPECT_EQ(sum(row_of(fcl, "all")), sum(row_of(boxes, "all")));
#endif
}

/// What is said of a command that starts no engine.
std::string refusal(const std::string& command) {
  try {
    start_engine(command, {.timeout = std::chrono::duration<double>(1)});
  } catch (const EngineMissingError& error) {
    return error.what();
  }
  return "none";
}

TEST(UsersEngine, ThatDoesNotSayWhoItIsIsRefused) {
  EXPECT_NE(refusal("exit 3").find("exit code 3"), std::string::npos) << refusal("exit 3");
  EXPECT_NE(refusal("/no/such/program").find("not found"), std::string::npos);
  EXPECT_NE(refusal("echo hello").find("cannot be read"), std::string::npos);
  EXPECT_NE(refusal("sleep 30").find("gave no answer in 1 s"), std::string::npos)
      << refusal("sleep 30");
  EXPECT_NE(refusal("echo '{\"graze_peer\":2,\"engine\":\"late\"}'").find("version 2"),
            std::string::npos);
}

}  // namespace
}  // namespace graze::compare

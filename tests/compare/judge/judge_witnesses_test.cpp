// The judge on trial: the points and normals that stand for an answer.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/compare/run/trial.h>
#include <gtest/gtest.h>

#include "tests/compare/judge/judged.h"

namespace graze::compare {
namespace {

using Vector = Eigen::Vector3d;

TEST(JudgeWitnesses, PointsOfADistanceLieOnTheSurfacesAndAreSoFarApart) {
  Case query = to_case(kFlat, moved(kFlat, Vector(0, 0, 1)), true);
  query.ask = Ask::Distance;
  const Judge judge(query);
  const auto judgement = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    CaseAnswer answer;
    answer.distance = 1;
    answer.point_a = a;
    answer.point_b = b;
    return judge.judge(answer, {"somebody", ""});
  };
  EXPECT_EQ(judgement({1, 1, 0}, {1, 1, 1}).verdict, Verdict::Right);
  EXPECT_EQ(judgement({1, 1, 0x1p-50}, {1, 1, 1}).verdict, Verdict::Right);
  const Judgement off_a = judgement({1, 1, 0.25}, {1, 1, 1.25});
  EXPECT_EQ(off_a.verdict, Verdict::Wrong);
  EXPECT_EQ(off_a.error, 0.25);
  EXPECT_EQ(judgement({1, 1, 0}, {1, 1, 1.5}).error, 0.5) << "off B";
  EXPECT_EQ(judgement({0, 0, 0}, {0, 0.75, 1}).error, 0.25) << "1.25 m from each other";
  EXPECT_EQ(judge.judge(answer_case(query), this_library()).verdict, Verdict::Right);
}

TEST(JudgeWitnesses, ContactsThatNoDefinitionAllows) {
  Case query = to_case(cube_at(0), cube_at(1.5), true);
  query.ask = Ask::Contacts;
  const Judge judge(query);
  const auto judgement = [&](const Eigen::Vector3d& normal, double depth) {
    CaseAnswer answer;
    answer.contacts = {{Vector(0.75, 0, 0), Vector(1, 0, 0), Vector(0.5, 0, 0), normal, depth}};
    return judge.judge(answer, {"somebody", ""});
  };
  const Judgement right = judgement({1, 0, 0}, 0.5);
  EXPECT_EQ(right.verdict, Verdict::Right);
  EXPECT_EQ(right.truth, "hit");
  EXPECT_EQ(judgement({1, 0, 0}, 7).verdict, Verdict::Wrong);
  EXPECT_EQ(judgement({1, 0, 0}, 7).error, 3.5)
      << "the longest separating translation along x is 3.5 m";
  EXPECT_EQ(judgement({0, 1, 0}, 0.5).error, 0.5)
      << "at right angles to the line between the points";
  EXPECT_EQ(judgement({2, 0, 0}, 0.5).error, 1);
  EXPECT_EQ(judge.judge(answer_case(query), this_library()).verdict, Verdict::Right);
  for (const EngineEntry& entry : all_engines()) {
    if (entry.engine == nullptr) continue;
    const std::optional<CaseAnswer> answer = ask(*entry.engine, query);
    if (!answer) continue;
    EXPECT_NE(judge.judge(*answer, entry.engine->name()).verdict, Verdict::Wrong) << entry.name;
  }
}

}  // namespace
}  // namespace graze::compare

// What is advised about wrong answers: what the data shows, and not more.

#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/run/advice/advice.h>
#include <graze/engine/compare/run/advice/evidence.h>
#include <graze/engine/compare/run/advice/plain_case.h>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/compare/judge/judged.h"

namespace graze::compare {
namespace {

Mesh mesh_of(const std::vector<Eigen::Vector3d>& vertices,
             const std::vector<TriangleIndices>& triangles) {
  return {vertices, triangles};
}

/// A triangle in the plane z = `height`, as a mesh.
CaseMesh sheet(double height, double pose_z) {
  Pose pose = Pose::Identity();
  pose.translation().z() = pose_z;
  return {mesh_of({{-1, -1, height}, {2, -1, height}, {-1, 2, height}}, {{0, 1, 2}}), pose};
}

/// A triangle that stands on its corner at this height.
CaseMesh dart(double height, double pose_z) {
  Pose pose = Pose::Identity();
  pose.translation().z() = pose_z;
  return {mesh_of({{0, 0, height}, {0, 0.25, height + 1}, {0.25, 0, height + 1}}, {{0, 1, 2}}),
          pose};
}

Case asked(CaseMesh a, CaseMesh b) {
  return {.note = "",
          .ask = Ask::Any,
          .settings = {},
          .a = std::move(a),
          .b = std::move(b),
          .answer = std::nullopt,
          .answered_by = {}};
}

/// The wrong answer to it.
WrongAnswer wrong(const Case& query, bool says) {
  AnswerRecord record{.engine = "mine",
                      .digest = "",
                      .brief = says ? "yes" : "no",
                      .time = 0,
                      .is_agreed = false,
                      .judgement = {}};
  record.judgement = judged(query.a, *query.b, says);
  EXPECT_TRUE(record.is_wrong());
  return {.place = 0,
          .where = "0",
          .name = "x",
          .answer = std::make_shared<const AnswerRecord>(record),
          .query = [query] { return query; }};
}

std::optional<Single> single_of(const Case& query, bool says) {
  return evidence_of(query, *wrong(query, says).answer).single;
}

constexpr double kNano = 0x1p-30;

TEST(Evidence, FloatIsFoundWhereItComesIn) {
  // 1 + 2^-30 is no float, and neither is its sum with what is left of it.
  EXPECT_EQ(single_of(asked(sheet(0, 0), dart(-1, 1 + kNano)), true), Single::Poses);
  EXPECT_EQ(single_of(asked(sheet(0, 0), dart(-1 + kNano, 1)), true), Single::Vertices);
  EXPECT_EQ(single_of(asked(sheet(1024, 0), dart(0x1p-20, 1024)), true), Single::Placed);
  EXPECT_EQ(single_of(asked(sheet(-kNano / 2, 0), dart(-1, 1 - kNano)), false), Single::Poses)
      << "a miss";
}

TEST(Evidence, FloatIsNotBlamedForWhatItDoesNotDo) {
  EXPECT_EQ(single_of(asked(sheet(0, 0), dart(0, 0.25)), true), std::nullopt) << "far too large";
  EXPECT_EQ(single_of(asked(sheet(0, 0), dart(0, kNano)), true), std::nullopt)
      << "a float, and so is all that is computed";
  EXPECT_EQ(single_of(asked(sheet(0, 0), dart(-1, 1 + 0x1p-52)), true), std::nullopt)
      << "rounding to double does";
}

WrongKind kind_of(const std::vector<WrongAnswer>& examples) {
  const Judgement& judgement = examples.front().answer->judgement;
  return {.engine = "mine",
          .version = "7",
          .error_class = judgement.error_class,
          .count = examples.size(),
          .largest_error = judgement.error,
          .largest_ulps = judgement.ulps,
          .examples = examples};
}

std::vector<Remedy> remedies(const Advice& advice) {
  std::vector<Remedy> all;
  for (const AdviceStep& step : advice.steps)
    all.push_back(step.remedy);
  return all;
}

TEST(Advice, ARealErrorIsReportedWithItsNumbers) {
  const std::vector<WrongAnswer> examples = {wrong(asked(sheet(0, 0), dart(0, 0.25)), true)};
  const Advice advice = advise(kind_of(examples));
  EXPECT_EQ(remedies(advice), std::vector{Remedy::Report});
  for (const char* part :
       {"# Wrong answer: says yes, the truth is apart by 0.25 m", "Engine: mine 7",
        "Expected: apart by 0.25 m", "off by 0.25 m", "do the two intersect", "\"vertices\""}) {
    EXPECT_NE(advice.issue.find(part), std::string::npos) << part << "\n" << advice.issue;
  }
  EXPECT_EQ(advice.issue.find("0x"), std::string::npos) << "plain numbers";
  // Whoever gets the issue can ask again.
  const std::size_t begin = advice.issue.find("```json\n") + 8;
  const std::string json = advice.issue.substr(begin, advice.issue.rfind("```") - begin);
  const Case again = parse_case(json, "the issue");
  EXPECT_EQ(to_json(again), to_json(examples.front().query()));
}

TEST(Advice, WhatFloatExplainsIsNoBug) {
  const std::vector<WrongAnswer> examples = {wrong(asked(sheet(0, 0), dart(-1, 1 + kNano)), true)};
  const Advice advice = advise(kind_of(examples));
  EXPECT_EQ(remedies(advice), std::vector{Remedy::Precision});
  EXPECT_EQ(advice.issue, "");
}

TEST(Advice, AStatedToleranceIsNoBugUpToIt) {
  const std::vector<WrongAnswer> examples = {wrong(asked(sheet(0, 0), dart(0, 0x1p-10)), true)};
  WrongKind kind = kind_of(examples);
  kind.tolerance = 1e-3;
  EXPECT_EQ(remedies(advise(kind)), std::vector{Remedy::Tolerance});
  kind.tolerance = 1e-4;
  EXPECT_EQ(remedies(advise(kind)), std::vector{Remedy::Report});
}

TEST(Advice, TouchingIsYourToleranceAndNamesIt) {
  const std::vector<WrongAnswer> examples = {wrong(asked(sheet(0, 0), dart(0, 3e-17)), true)};
  WrongKind kind = kind_of(examples);
  ASSERT_NE(kind.error_class, ErrorClass::Real);
  kind.error_class = ErrorClass::Touching;
  const Advice advice = advise(kind);
  ASSERT_EQ(remedies(advice), std::vector{Remedy::Tolerance});
  EXPECT_NE(advice.steps[0].words.find("nearer than 1e-16 m"), std::string::npos)
      << advice.steps[0].words;
  EXPECT_NE(advice.steps[0].words.find("--fail-on 'mine>1e-16'"), std::string::npos);
  EXPECT_EQ(advice.issue, "");
}

TEST(Advice, TrianglesWithoutAreaAreNamed) {
  const Mesh flat = mesh_of({{0, 0, -1}, {0, 0, 1}, {0, 0, 0.5}, {9, 9, 9}, {9, 8, 9}, {8, 9, 9}},
                            {{3, 4, 5}, {0, 1, 2}});
  const Case query = asked(sheet(0, 0), CaseMesh(flat, Pose::Identity()));
  const std::vector<WrongAnswer> examples = {wrong(query, false)};
  WrongKind kind = kind_of(examples);
  ASSERT_EQ(kind.error_class, ErrorClass::Degenerate);
  kind.name_b = "part.stl";
  const Advice advice = advise(kind);
  ASSERT_EQ(remedies(advice).front(), Remedy::Triangles);
  EXPECT_NE(advice.steps[0].words.find("1 of the 2 triangles of part.stl (1)"), std::string::npos)
      << advice.steps[0].words;
}

TEST(Advice, NoAnswerIsGuardedAgainstAndReported) {
  WrongAnswer crash = wrong(asked(sheet(0, 0), dart(0, 0.25)), true);
  AnswerRecord record = *crash.answer;
  record.judgement = engine_error("died of SIGSEGV");
  record.brief = "nothing";
  crash.answer = std::make_shared<const AnswerRecord>(record);
  const std::vector<WrongAnswer> examples = {crash};
  const Advice advice = advise(kind_of(examples));
  EXPECT_EQ(remedies(advice), (std::vector{Remedy::Guard, Remedy::Report}));
  EXPECT_NE(advice.issue.find("died of SIGSEGV"), std::string::npos);
}

/// As of the parts of a run that are merged, which have no meshes.
TEST(Advice, WithoutAQueryOnlySizesCount) {
  WrongAnswer bare = wrong(asked(sheet(0, 0), dart(0, 0.25)), true);
  bare.query = nullptr;
  const std::vector<WrongAnswer> examples = {bare};
  const Advice advice = advise(kind_of(examples));
  EXPECT_EQ(remedies(advice), std::vector{Remedy::Report});
  EXPECT_EQ(advice.issue.find("json"), std::string::npos);
}

TEST(PlainCase, ReadsBackAsTheSameCase) {
  Case query = asked(sheet(-0.0, 0.1), dart(0x1p-1074, 1.0 / 3));
  query.note = "a \"0x1p+0\" in words";
  const std::string plain = with_plain_numbers(to_json(query));
  EXPECT_EQ(to_json(parse_case(plain, "plain")), to_json(query));
  EXPECT_NE(plain.find("0.3333333333333333"), std::string::npos) << plain;
}

}  // namespace
}  // namespace graze::compare

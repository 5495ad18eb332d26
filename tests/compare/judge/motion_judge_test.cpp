// The verdict on first contacts: wrong answers of each kind, made by hand, and right ones.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/motion_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <string>

#include "tests/shapes/formula_meshes.h"

namespace graze::compare {
namespace {

/// What somebody says of a first contact.
CaseAnswer contact_answer(RigidStatus status, double low, double high) {
  CaseAnswer answer;
  answer.status = status;
  answer.low = low;
  answer.high = high;
  return answer;
}

CaseAnswer hit_at(double time) {
  return contact_answer(RigidStatus::Hit, time, time);
}

CaseAnswer free_answer(bool says) {
  CaseAnswer answer;
  answer.says = says;
  return answer;
}

const CaseAnswer kFree = contact_answer(RigidStatus::Free, 1, 1);

class MotionVerdicts : public testing::Test {
 protected:
  /// A cube of two metres that rests, and one that goes along x from a gap of one metre.
  Case towards(const Eigen::Vector3d& start, double shift, Ask ask = Ask::FirstContact) const {
    const RigidMotion motion(Pose(Eigen::Translation3d(start)), {.shift = {shift, 0, 0}});
    Case query = to_case_free(case_mesh(cube_, rests_), case_mesh(cube_, motion), true);
    query.ask = ask;
    query.answer.reset();
    return query;
  }

  static Judgement judged(const Case& query, const CaseAnswer& answer,
                          const std::string& engine = "somebody") {
    return Judge(query).judge(answer, {engine, ""});
  }

  static void expect_wrong(const Judgement& judgement, const std::string& cause, double error) {
    EXPECT_EQ(judgement.verdict, Verdict::Wrong) << judgement.truth;
    EXPECT_EQ(judgement.error_class, ErrorClass::Real) << judgement.truth;
    EXPECT_NE(judgement.truth.find(cause), std::string::npos) << judgement.truth;
    EXPECT_NEAR(judgement.error, error, 1e-5) << judgement.truth;
  }

  Mesh cube_ = tests::make_box({1, 1, 1});
  RigidMotion rests_{Pose::Identity()};
};

/// They meet at t = 0.5.
TEST_F(MotionVerdicts, OfAHit) {
  const Case query = towards({3, 0, 0}, -2);
  const CaseAnswer own = answer_case(query);
  EXPECT_EQ(judged(query, own, "graze").verdict, Verdict::Right);
  EXPECT_EQ(judged(query, own).verdict, Verdict::Right);
  EXPECT_EQ(judged(query, hit_at(0.5)).verdict, Verdict::Right);
  EXPECT_EQ(judged(query, hit_at(0.5001)).verdict, Verdict::Right) << "others have a tolerance";
  EXPECT_EQ(judged(query, hit_at(0.4999)).verdict, Verdict::Right);
  expect_wrong(judged(query, kFree), "missed", 1);
  expect_wrong(judged(query, hit_at(0.75)), "late by 0.25", 0.5);
  expect_wrong(judged(query, hit_at(0.25)), "early by 0.25", 0.5);
  expect_wrong(judged(query, hit_at(0)), "early by 0.5", 1);
}

/// They touch from 0.49 to 0.51, between the fifth and the sixth of ten poses; or at one of them.
TEST_F(MotionVerdicts, OfWhatPosesDoNotSee) {
  const Judgement between = judged(towards({103, 0, 0}, -206), kFree);
  EXPECT_EQ(between.verdict, Verdict::Wrong);
  EXPECT_NE(between.truth.find("missed, sampled over"), std::string::npos) << between.truth;
  const Judgement seen = judged(towards({206.0 * 4 / 9, 0, 0}, -206), kFree);
  EXPECT_EQ(seen.verdict, Verdict::Wrong);
  EXPECT_EQ(seen.truth.find("sampled over"), std::string::npos) << seen.truth;
  EXPECT_EQ(judged(towards({3, 0, 0}, -2), kFree).truth.find("sampled over"), std::string::npos);
}

TEST_F(MotionVerdicts, OfWhatGrazePromises) {
  const Case query = towards({3, 0, 0}, -2);
  const CaseAnswer own = answer_case(query);
  CaseAnswer answer = own;
  answer.low = *own.high;
  answer.high = std::nextafter(*own.high, 1);
  EXPECT_NE(judged(query, answer, "graze").verdict, Verdict::Right) << "no room for late times";
  answer = own;
  answer.high = *own.low;
  EXPECT_EQ(judged(query, answer, "graze").verdict, Verdict::Wrong) << "the witness is none";
  expect_wrong(judged(query, contact_answer(RigidStatus::Hit, 0.625, 0.75), "graze"), "late", 0.25);
  expect_wrong(judged(query, contact_answer(RigidStatus::Close, 0.625, 1), "graze"), "late", 0.25);
}

TEST_F(MotionVerdicts, OfAFreeMotion) {
  const Case query = towards({3, 2.25, 0}, -6);
  EXPECT_EQ(judged(query, answer_case(query), "graze").verdict, Verdict::Right);
  EXPECT_EQ(judged(query, kFree).verdict, Verdict::Right);
  expect_wrong(judged(query, hit_at(0.5)), "\"hit\" of a free motion", 0.25);
  expect_wrong(judged(query, contact_answer(RigidStatus::Close, 0.5, 1)), "\"close\"", 0.25);
}

TEST_F(MotionVerdicts, OfYesAndNo) {
  const Case hit = towards({3, 0, 0}, -2, Ask::Free);
  EXPECT_EQ(judged(hit, answer_case(hit), "graze").verdict, Verdict::Right);
  EXPECT_EQ(judged(hit, free_answer(false)).verdict, Verdict::Right);
  expect_wrong(judged(hit, free_answer(true)), "missed", 1);
  const Case free = towards({3, 2.25, 0}, -6, Ask::Free);
  EXPECT_EQ(judged(free, answer_case(free), "graze").verdict, Verdict::Right);
  EXPECT_EQ(judged(free, free_answer(true)).verdict, Verdict::Right);
  const Judgement invented = judged(free, free_answer(false));
  expect_wrong(invented, "\"hit\" of a free motion", 0.25);
}

/// They pass each other nearer than the tolerance: that they meet is not proved, nor that not.
TEST_F(MotionVerdicts, OfWhatComesClose) {
  const Case query = towards({3, 2.0000005, 0}, -6);
  const CaseAnswer own = answer_case(query);
  ASSERT_EQ(*own.status, RigidStatus::Close);
  EXPECT_EQ(judged(query, own, "graze").verdict, Verdict::Right);
  for (const CaseAnswer& claim : {kFree, hit_at(*own.low)}) {
    const Judgement judgement = judged(query, claim);
    EXPECT_EQ(judgement.verdict, Verdict::NotJudged);
    EXPECT_NE(judgement.truth.find("not judged"), std::string::npos) << judgement.truth;
  }
  const Case yes_or_no = towards({3, 2.0000005, 0}, -6, Ask::Free);
  EXPECT_EQ(judged(yes_or_no, free_answer(false), "graze").verdict, Verdict::Right);
  EXPECT_EQ(judged(yes_or_no, free_answer(false)).verdict, Verdict::NotJudged);
}

TEST_F(MotionVerdicts, OfAClearance) {
  Case query = towards({3, 2.25, 0}, -6);
  query.settings.clearance = 0.5;
  query.settings.tolerance = 1e-3;
  const CaseAnswer own = answer_case(query);
  ASSERT_EQ(*own.status, RigidStatus::Hit);
  EXPECT_EQ(judged(query, own, "graze").verdict, Verdict::Right);
  const Judgement missed = judged(query, kFree);
  EXPECT_EQ(missed.verdict, Verdict::Wrong);
  EXPECT_NE(missed.truth.find("missed"), std::string::npos);
  EXPECT_NEAR(missed.error, 0.25, 1e-9);
}

TEST_F(MotionVerdicts, OfTurns) {
  const RigidMotion turns(Pose(Eigen::Translation3d(2.25, 0, 0)),
                          {.centre = {2.25, 0, 0}, .axis = {0, 0, 1}, .angle = 0.5});
  Case query = to_case(case_mesh(cube_, rests_), case_mesh(cube_, turns),
                       first_contact({cube_, rests_}, {cube_, turns}));
  ASSERT_EQ(*query.answer->status, RigidStatus::Hit);
  EXPECT_EQ(judged(query, *query.answer, "graze").verdict, Verdict::Right);
  EXPECT_EQ(judged(query, kFree).verdict, Verdict::Wrong);
  EXPECT_EQ(judged(query, hit_at(1)).verdict, Verdict::Wrong);
}

TEST_F(MotionVerdicts, OfBodies) {
  const Shape ball(Sphere{{0, 0, 0}, 1}), whole(cube_);
  const RigidMotion comes(Pose(Eigen::Translation3d(3, 0, 0)), {.shift = {-2, 0, 0}});
  const Case balls = to_case(case_body(ball, rests_), case_body(ball, comes),
                             first_contact({ball, rests_}, {ball, comes}));
  expect_wrong(judged(balls, kFree), "missed", 1);
  EXPECT_EQ(judged(balls, hit_at(0.75)).verdict, Verdict::Wrong);
  EXPECT_EQ(judged(balls, *balls.answer, "graze").verdict, Verdict::Right);
  expect_wrong(judged(balls, hit_at(0.25)), "early by 0.25", 0.5);
  const Shape cone(Cone{1, 1});
  const RigidMotion turns(Pose(Eigen::Translation3d(0, 0, 2.5)),
                          {.centre = {0, 0, 2.5}, .axis = {1, 0, 0}, .angle = 3});
  const Case free = to_case(case_body(ball, rests_), case_body(cone, turns),
                            first_contact({ball, rests_}, {cone, turns}));
  ASSERT_EQ(*free.answer->status, RigidStatus::Free);
  EXPECT_EQ(judged(free, kFree).verdict, Verdict::Right);
  EXPECT_EQ(judged(free, hit_at(0.5)).verdict, Verdict::Wrong);
  const Case meshes = to_case(case_body(whole, rests_), case_body(whole, comes),
                              first_contact({whole, rests_}, {whole, comes}));
  EXPECT_EQ(judged(meshes, *meshes.answer, "graze").verdict, Verdict::Right);
  expect_wrong(judged(meshes, hit_at(0.75)), "late", 0.5);
}

TEST_F(MotionVerdicts, OfWhatIsNoAnswer) {
  const Case query = towards({3, 0, 0}, -2);
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const CaseAnswer& answer :
       {hit_at(none), hit_at(-1), hit_at(2), contact_answer(RigidStatus::Hit, 0.5, 0.25),
        free_answer(true), CaseAnswer()})
    EXPECT_EQ(judged(query, answer).error_class, ErrorClass::EngineError);
}

}  // namespace
}  // namespace graze::compare

// Other engines' first contacts, each setting of theirs: times that are known by hand, and what is
// not asked.

#include <graze/engine/cases/motion_case.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/shapes/formula_meshes.h"

namespace graze::compare {
namespace {

/// Whom to ask about motions, and what.
class MotionPeers : public testing::Test {
 protected:
  void SetUp() override {
    // FCL's polynomials replace a mesh's vertices: what its library, of C++11, took from Eigen's
    // malloc(), its headers give back by delete[] where they are compiled as C++20.
    const char* options = std::getenv("ASAN_OPTIONS");
    const std::string allowed =
        std::string(options == nullptr ? "" : options) + ":alloc_dealloc_mismatch=0";
    setenv("ASAN_OPTIONS", allowed.c_str(), 1);
    engines_ = all_engines();
    for (EngineEntry& entry : motion_engines())
      engines_.push_back(std::move(entry));
    if (engine("fcl") == nullptr) GTEST_SKIP() << "FCL was not found when this was built";
  }

  const Engine* engine(const std::string& name) const {
    for (const EngineEntry& entry : engines_)
      if (entry.name == name) return entry.engine.get();
    return nullptr;
  }

  /// A cube of two metres that rests, and one that comes along x from a gap of one metre.
  Case towards(const RigidCourse& course) const {
    const RigidMotion comes(Pose(Eigen::Translation3d(3, 0, 0)), course);
    Case query = to_case_free(case_mesh(cube_, RigidMotion(Pose::Identity())),
                              case_mesh(cube_, comes), true);
    query.ask = Ask::FirstContact;
    query.answer.reset();
    return query;
  }

  Mesh cube_ = tests::make_box({1, 1, 1});
  std::vector<EngineEntry> engines_;
};

TEST_F(MotionPeers, FclSaysAtWhichOfItsSamplesTheyMeet) {
  Case query = towards({.shift = {-2, 0, 0}});
  const std::optional<CaseAnswer> answer = ask(*engine("fcl"), query);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, RigidStatus::Hit);
  EXPECT_EQ(answer->low, 5.0 / 9);
  EXPECT_EQ(answer->high, 5.0 / 9);
  const Judgement judgement = Judge(query).judge(*answer, {"fcl", ""});
  EXPECT_EQ(judgement.verdict, Verdict::Wrong) << judgement.truth;
  EXPECT_NE(judgement.truth.find("late"), std::string::npos) << judgement.truth;
  query.ask = Ask::Free;
  EXPECT_EQ(ask(*engine("fcl"), query)->says, false);
  std::swap(query.a, *query.b);
  EXPECT_EQ(ask(*engine("fcl"), query)->says, false) << "A moves, and B rests";
}

TEST_F(MotionPeers, BothWaysOfFclMove) {
  // Turned by a right angle about its own middle and moved away: apart all the time.
  const Case away =
      towards({.centre = {3, 0, 0}, .shift = {4, 0, 0}, .axis = {1, 0, 0}, .angle = 1.5});
  for (const char* name : {"fcl", "fcl-advancement"}) {
    const std::optional<CaseAnswer> answer = ask(*engine(name), away);
    ASSERT_TRUE(answer) << name;
    EXPECT_EQ(answer->status, RigidStatus::Free) << name;
    EXPECT_EQ(Judge(away).judge(*answer, {name, ""}).verdict, Verdict::Right) << name;
    const std::unique_ptr<Engine> alone = engine(name)->alone();
    EXPECT_TRUE(is_same(*ask(*alone, away), *answer)) << name;
  }
}

TEST_F(MotionPeers, FclKnowsShapesToo) {
  const Shape ball(Sphere{{0.5, 0, 0}, 1}), box(Box{{1, 1, 1}});
  const RigidMotion rests{Pose::Identity()};
  const RigidMotion comes(Pose(Eigen::Translation3d(-3.5, 0, 0)), {.shift = {2, 0, 0}});
  Case query = to_case(case_body(box, rests), case_body(ball, comes),
                       first_contact({box, rests}, {ball, comes}));
  query.answer.reset();
  const std::optional<CaseAnswer> sampled = ask(*engine("fcl"), query);
  ASSERT_TRUE(sampled);
  EXPECT_EQ(sampled->status, RigidStatus::Hit);
  EXPECT_EQ(sampled->low, 5.0 / 9);
  const std::optional<CaseAnswer> advanced = ask(*engine("fcl-advancement"), query);
  ASSERT_TRUE(advanced);
  EXPECT_EQ(advanced->status, RigidStatus::Hit) << *advanced->low;
  EXPECT_NEAR(*advanced->low, 0.5, 0x1p-10);
  const Case touch =
      to_case(CaseShape(CaseBody(box, Pose::Identity())), CaseBody(ball, Pose::Identity()), true);
  EXPECT_FALSE(ask(*engine("fcl-advancement"), touch)) << "a question without a motion";
}

TEST_F(MotionPeers, WhatTheyDoNotKnowIsNotAsked) {
  Case query = towards({.centre = {3, 0, 0}, .axis = {0, 0, 1}, .angle = 3});
  EXPECT_FALSE(ask(*engine("fcl"), query)) << "the short way may be another";
  query = towards({.shift = {-2, 0, 0}});
  for (const char* name : {"bullet", "ode", "coal"}) {
    if (engine(name) == nullptr) continue;
    EXPECT_FALSE(ask(*engine(name), query)) << name;
  }
  query.settings.clearance = 0.5;
  EXPECT_FALSE(ask(*engine("fcl"), query)) << "a clearance";
  EXPECT_FALSE(ask(*engine("fcl-advancement"), query)) << "a clearance";
  const Case any = to_case({cube_}, {cube_}, true);
  EXPECT_FALSE(ask(*engine("fcl-advancement"), any)) << "a question without a motion";
}

/// What an engine says of a first contact; -1 if it does not know such a question, 2 for none.
double said(const Engine& engine, const Case& query) {
  const std::optional<CaseAnswer> answer = ask(engine, query);
  if (!answer) return -1;
  return *answer->status == RigidStatus::Hit ? *answer->low : 2;
}

Case about(const Shape& a, const RigidMotion& motion_a, const Shape& b,
           const RigidMotion& motion_b) {
  Case query = to_case(case_body(a, motion_a), case_body(b, motion_b),
                       RigidContact{RigidStatus::Free, 1, 1, false});
  query.answer.reset();
  return query;
}

const RigidMotion kRests{Pose::Identity()};

/// A body that goes along x by 2 m, from so far.
RigidMotion comes_from(double x) {
  return {Pose(Eigen::Translation3d(x, 0, 0)), {.centre = {x, 0, 0}, .shift = {2, 0, 0}}};
}

TEST_F(MotionPeers, EachOtherSettingIsAsked) {
  std::string names;
  for (const EngineEntry& entry : motion_engines()) {
    EXPECT_TRUE(entry.is_only_if_named);
    names += entry.name + " ";
  }
  EXPECT_EQ(names,
            "fcl-1000 fcl-swapped fcl-translation fcl-screw fcl-spline fcl-polynomial "
            "fcl-advancement-swapped fcl-advancement-indep fcl-advancement-fine "
            "fcl-advancement-translation fcl-advancement-screw bullet-subsimplex bullet-gjk ");
  const Case one = towards({.shift = {-2, 0, 0}});
  Case both = towards({.shift = {-1, 0, 0}});
  std::get<CaseMesh>(both.a).course = RigidCourse{.shift = {1, 0, 0}};
  Case swapped = one;
  std::swap(swapped.a, *swapped.b);
  for (const Case& query : {one, both, swapped}) {  // they meet at 0.5
    EXPECT_EQ(said(*engine("fcl-1000"), query), 500.0 / 999);
    for (const char* name : {"fcl-swapped", "fcl-translation", "fcl-spline"})
      EXPECT_EQ(said(*engine(name), query), 5.0 / 9) << name;
    EXPECT_NEAR(said(*engine("fcl-polynomial"), query), 0.5, 1e-9);
  }
}

TEST_F(MotionPeers, FclsPolynomialsStartWhereTheMeshesAre) {
  Case query = towards({.shift = {-2, 0, 0}});
  // A quarter turn of A about z changes nothing of a cube, and of what is placed much.
  auto& a = std::get<CaseMesh>(query.a);
  a.pose.linear() = Eigen::AngleAxisd(0x1.921fb54442d18p+0, Eigen::Vector3d::UnitZ()).matrix();
  a.pose.translation().x() = -0.5;
  a.course.reset();
  EXPECT_NEAR(said(*engine("fcl-polynomial"), query), 0.75, 1e-9);
  EXPECT_NEAR(said(*engine("fcl-polynomial"), query), 0.75, 1e-9) << "asked again";
}

TEST_F(MotionPeers, FclsScrewsThatDoNotTurnGoTooFar) {
  const Case straight = towards({.shift = {-2, 0, 0}});
  const std::optional<CaseAnswer> answer = ask(*engine("fcl-screw"), straight);
  ASSERT_TRUE(answer);
  EXPECT_EQ(*answer->low, 3.0 / 9) << "2 m times 2 m on its way";
  const Judgement judgement = Judge(straight).judge(*answer, {"fcl-screw", ""});
  EXPECT_EQ(judgement.verdict, Verdict::Wrong) << judgement.truth;
  EXPECT_NE(judgement.truth.find("early"), std::string::npos) << judgement.truth;
  const Case turning =
      towards({.centre = {3, 0, 0}, .shift = {-2, 0, 0}, .axis = {1, 0, 0}, .angle = 1});
  EXPECT_EQ(said(*engine("fcl-screw"), turning), 5.0 / 9);
  const Case no_screw =
      towards({.centre = {3, 0, 0}, .shift = {-2, 0, 0}, .axis = {0, 0, 1}, .angle = 1});
  EXPECT_EQ(said(*engine("fcl-screw"), no_screw), -1);
}

TEST_F(MotionPeers, FclsAdvancementHasSettings) {
  const Shape ball(Sphere{{0.5, 0, 0}, 1}), box(Box{{1, 1, 1}});
  const Case query = about(box, kRests, ball, comes_from(-3.5));
  for (const char* name : {"fcl-advancement-swapped", "fcl-advancement-indep",
                           "fcl-advancement-fine", "fcl-advancement-translation"})
    EXPECT_NEAR(said(*engine(name), query), 0.5, 0x1p-10) << name;
  // FCL's first geometry is asked otherwise than the second: here by the last digits.
  const Shape capsule(Capsule{0.3, 0.5});
  const RigidMotion turns(
      Pose(Eigen::Translation3d(-2.5, 0.2, 0.1)),
      {.centre = {-2.5, 0.2, 0.1}, .shift = {2, 0.1, 0}, .axis = {1, 2, 3}, .angle = 1});
  Case turning = about(box, kRests, capsule, turns);
  const double swapped = said(*engine("fcl-advancement-swapped"), turning);
  const double kept = said(*engine("fcl-advancement"), turning);
  EXPECT_NE(kept, swapped);
  EXPECT_NEAR(kept, swapped, 1e-3);
  std::swap(turning.a, *turning.b);
  EXPECT_EQ(said(*engine("fcl-advancement"), turning), swapped);
  EXPECT_EQ(said(*engine("fcl-advancement-swapped"), turning), kept);
  EXPECT_EQ(said(*engine("fcl-advancement-translation"), turning), -1) << "it turns";
}

class BulletCasts : public MotionPeers {
 protected:
  void SetUp() override {
    MotionPeers::SetUp();
    if (engine("bullet") == nullptr) GTEST_SKIP() << "Bullet was not found when this was built";
  }
};

TEST_F(BulletCasts, MeetWhereTheFormulaSays) {
  const Shape ball(Sphere{{0.5, 0, 0}, 1}), box(Box{{1, 1, 1}}), mesh(cube_);
  const Shape ground(HalfSpace{{-1, 0, 0}, 1});  // all of x >= -1
  const RigidMotion comes = comes_from(-3.5), passes = comes_from(-7);
  for (const char* name : {"bullet", "bullet-subsimplex", "bullet-gjk"}) {
    const Engine& bullet = *engine(name);
    EXPECT_NEAR(said(bullet, about(box, kRests, ball, comes)), 0.5, 1e-3) << name;
    EXPECT_NEAR(said(bullet, about(ball, comes, box, kRests)), 0.5, 1e-3) << name;
    EXPECT_EQ(said(bullet, about(box, kRests, ball, passes)), 2) << name;
    const RigidMotion half(comes.start(), {.shift = {1, 0, 0}});
    const RigidMotion back(Pose::Identity(), {.shift = {-1, 0, 0}});
    EXPECT_NEAR(said(bullet, about(box, back, ball, half)), 0.5, 1e-3) << name;
    const bool is_first = name == std::string("bullet");
    for (const Shape& other : {mesh, ground}) {
      for (const auto& [a, b] : {std::pair(about(other, kRests, ball, comes), 0.5),
                                 std::pair(about(ball, comes, other, kRests), 0.5),
                                 std::pair(about(ball, half, other, back), 0.5),
                                 std::pair(about(ball, passes, other, kRests), 2.0)})
        EXPECT_NEAR(said(bullet, a), is_first ? b : -1, 1e-3) << name;
    }
  }
  // A thousandth as large they meet at 0.5, too, and Bullet stops a millimetre before.
  const Shape small_ball(Sphere{{0.0005, 0, 0}, 0.001}), small_box(Box{{0.001, 0.001, 0.001}});
  const RigidMotion small(Pose(Eigen::Translation3d(-0.0035, 0, 0)), {.shift = {0.002, 0, 0}});
  EXPECT_LT(said(*engine("bullet"), about(small_box, kRests, small_ball, small)), 0.25);
  EXPECT_NEAR(said(*engine("bullet-subsimplex"), about(small_box, kRests, small_ball, small)), 0.5,
              1e-3);
  Case free = about(box, kRests, ball, passes);
  free.ask = Ask::Free;
  EXPECT_EQ(ask(*engine("bullet"), free)->says, true);
}

TEST_F(BulletCasts, TurnByLessThanAnEighthAboutTheirOrigin) {
  const Shape box(Box{{1, 1, 1}}), mesh(cube_);
  const auto turns = [](double angle, const Eigen::Vector3d& centre) {
    return RigidMotion(Pose(Eigen::Translation3d(2.25, 0, 0)),
                       {.centre = centre, .axis = {0, 0, 1}, .angle = angle});
  };
  // A corner of the turned box is at 2.25 - sqrt(2) cos(pi / 4 - angle).
  const double met = (0x1.921fb54442d18p-1 - std::acos(1.25 / std::sqrt(2.0))) / 0.5;
  const Case query = about(box, kRests, box, turns(0.5, {2.25, 0, 0}));
  EXPECT_NEAR(said(*engine("bullet"), query), met, 0x1p-8);
  EXPECT_EQ(said(*engine("bullet-subsimplex"), query), -1);
  EXPECT_EQ(said(*engine("bullet-gjk"), query), -1);
  const auto unknown = [&](const Shape& a, const RigidMotion& motion_a, const Shape& b,
                           const RigidMotion& motion_b) {
    return said(*engine("bullet"), about(a, motion_a, b, motion_b)) == -1;
  };
  EXPECT_TRUE(unknown(box, kRests, box, turns(0.8, {2.25, 0, 0}))) << "too far";
  EXPECT_TRUE(unknown(box, kRests, box, turns(0.5, {2, 0, 0}))) << "about another point";
  EXPECT_TRUE(unknown(box, kRests, mesh, turns(0.5, {2.25, 0, 0}))) << "a mesh that turns";
  EXPECT_FALSE(unknown(mesh, kRests, box, turns(0.5, {2.25, 0, 0})));
  EXPECT_TRUE(unknown(mesh, kRests, mesh, comes_from(-3.5))) << "two meshes";
  EXPECT_TRUE(unknown(Ellipsoid{{0, 0, 0}, {1, 1, 1}}, kRests, box, comes_from(-3.5)));
  Case far = about(box, kRests, box, comes_from(-3.5));
  far.settings.clearance = 0.5;
  EXPECT_EQ(said(*engine("bullet"), far), -1) << "a clearance";
}

}  // namespace
}  // namespace graze::compare

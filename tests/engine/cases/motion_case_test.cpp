// Cases about motions: what is written, what may be left out, and what is refused with its place.

#include <graze/bvh/error.h>
#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/motion_case.h>
#include <graze/engine/cases/read_case.h>
#include <gtest/gtest.h>
#include <cmath>
#include <string>

#include "tests/shapes/formula_meshes.h"

namespace graze {
namespace {

class MotionCase : public testing::Test {
 protected:
  /// Two cubes of two metres, the second of which comes along x from three metres away.
  Case comes() const {
    return to_case(case_mesh(cube_, rests_), case_mesh(cube_, comes_),
                   first_contact({cube_, rests_}, {cube_, comes_}));
  }

  Mesh cube_ = tests::make_box({1, 1, 1});
  RigidMotion rests_{Pose::Identity()};
  RigidMotion comes_{Pose(Eigen::Translation3d(3, 0, 0)), {.shift = {-2, 0, 0}}};
};

TEST_F(MotionCase, SaysWhenTheyMeet) {
  const Case query = comes();
  ASSERT_TRUE(query.answer->status && query.answer->low && query.answer->high);
  EXPECT_EQ(*query.answer->status, RigidStatus::Hit);
  EXPECT_NEAR(*query.answer->low, 0.5, 1e-6);
  EXPECT_NEAR(*query.answer->high, 0.5, 1e-6);
  const std::string text = to_json(query);
  for (const char* part : {"\"question\": \"first_contact\"", "\"status\":\"hit\"",
                           "\"motion\": {\"centre\"", "\"tolerance\""})
    EXPECT_NE(text.find(part), text.npos) << part << text;
  const Case back = parse_case(text, "memory");
  EXPECT_TRUE(motion_of(std::get<CaseMesh>(*back.b)) == comes_);
  EXPECT_TRUE(is_same(answer_case(back), *query.answer));
}

TEST_F(MotionCase, AMotionOfManyTurnsComesBackToTheBit) {
  const RigidMotion turns(
      Pose(Eigen::Translation3d(0.1, 0.2, 0.3)),
      {.centre = {0.7, 1e-9, 0.1}, .shift = {1, 2, 0.3}, .axis = {1, 1, 0.3}, .angle = 1234.5});
  const Case query = to_case_free(case_mesh(cube_, rests_), case_mesh(cube_, turns), false);
  const Case back = parse_case(to_json(query), "memory");
  EXPECT_TRUE(motion_of(std::get<CaseMesh>(*back.b)) == turns);
  EXPECT_EQ(to_json(back), to_json(query));
}

TEST_F(MotionCase, OneBitMoreIsAnotherAnswer) {
  const CaseAnswer answer = *comes().answer;
  CaseAnswer later = answer, status = answer, before = answer;
  *later.high = std::nextafter(*later.high, 1);
  status.status = RigidStatus::Close;
  *before.low = std::nextafter(*before.low, 0);
  for (const CaseAnswer& other : {later, status, before}) {
    EXPECT_FALSE(is_same(answer, other));
    EXPECT_NE(to_json(answer), to_json(other));
  }
}

TEST_F(MotionCase, WhatHangsOnABudgetIsNoCase) {
  const CaseMesh a = case_mesh(cube_, rests_), b = case_mesh(cube_, comes_);
  const RigidContactSettings none{.budget = 0}, more{.budget = std::uint64_t{1} << 30};
  const RigidContact ended = first_contact({cube_, rests_}, {cube_, comes_}, none);
  ASSERT_TRUE(ended.is_out_of_budget);
  EXPECT_THROW(to_case(a, b, ended, none), InputError);
  EXPECT_THROW(to_case(a, b, first_contact({cube_, rests_}, {cube_, comes_}), more), InputError);
  EXPECT_THROW(to_case_free(a, b, false, none), InputError);
  const RigidContactSettings enough{.budget = 100000};
  EXPECT_NO_THROW(to_case(a, b, first_contact({cube_, rests_}, {cube_, comes_}, enough), enough));
}

constexpr const char* kBall = R"({"body": {"sphere": {"radius": 1}})";

std::string motion_refusal(const std::string& text) {
  try {
    parse_case(text, "c");
  } catch (const CaseError& error) {
    return error.what();
  }
  return "";
}

std::string moving(const std::string& question, const std::string& motion,
                   const std::string& more = "") {
  return R"({"graze_case": 1, "question": ")" + question + R"(", "a": )" + kBall + R"(}, "b": )" +
         kBall + R"(, "pose": [1,0,0,3, 0,1,0,0, 0,0,1,0])" + ",\n\"motion\": " + motion + "}" +
         more + "}";
}

TEST(HostileMotion, WhatMayBeLeftOut) {
  EXPECT_EQ(motion_refusal(moving("free", "{}")), "");
  EXPECT_EQ(motion_refusal(moving("free", R"({"shift": [1,0,0]})")), "");
  EXPECT_EQ(motion_refusal(moving("free", R"({"centre": [0,0,0], "axis": [0,0,2], "angle": 1})")),
            "");
  EXPECT_EQ(motion_refusal(moving("first_contact", "{}", R"(, "settings": {"tolerance": 0})")), "");
}

TEST(HostileMotion, WhatIsNoMotion) {
  EXPECT_EQ(motion_refusal(moving("free", R"({"centre": [0,0,0]})")),
            "c:2: /b/motion: has no \"axis\"");
  EXPECT_EQ(motion_refusal(moving("free", R"({"way": 1})")),
            "c:2: /b/motion: unknown key \"way\"; there are centre, shift, axis, angle");
  EXPECT_EQ(motion_refusal(moving("free", R"({"centre": [0,0,0], "axis": [0,0,0], "angle": 1})")),
            "c:2: /b/motion: axis of a motion: it has no direction");
  EXPECT_EQ(motion_refusal(moving("free", R"({"centre": [0,0,0], "axis": [0,0,1], "angle": 1e9})")),
            "c:2: /b/motion: angle of a motion: 1e+09 is not within 1.04858e+06 radians");
  EXPECT_EQ(motion_refusal(moving("free", R"({"shift": [1e200,0,0]})")).substr(0, 27),
            "c:2: /b/motion: the motion:");
  EXPECT_EQ(motion_refusal(moving("any", "{}")),
            "c:2: /b/motion: only \"first_contact\" and \"free\" are about motions");
  const std::string ray =
      R"({"graze_case": 1, "question": "ray", "a": {"triangle": [[0,0,0],[1,0,0],[0,1,0]]}, "b": {"ray": {"origin": [0,0,0], "direction": [0,0,1]}, "motion": {}}})";
  EXPECT_EQ(motion_refusal(ray), "c:1: /b/motion: only a mesh and a body move");
}

TEST(HostileMotion, WhatNoQueryAnswers) {
  const std::string plane = R"({"body": {"half_space": {"normal": [0,0,1]}})";
  const std::string turn = R"(, "motion": {"centre": [0,0,0], "axis": [1,0,0], "angle": 1}})";
  EXPECT_EQ(motion_refusal(R"({"graze_case": 1, "question": "free", "a": )" + plane +
                           R"(}, "b": )" + plane + turn + "}"),
            "c:1: /question: of two half-spaces or planes none may turn: they meet far away");
  EXPECT_EQ(
      motion_refusal(
          R"({"graze_case": 1, "question": "free", "a": {"sphere": {"centre": [0,0,0], "radius": 1}}, "b": {"point": [0,0,0]}})"),
      "c:1: /question: no query answers \"free\" for a sphere and a point");
}

TEST(HostileMotion, SettingsAndAnswers) {
  const auto answered = [](const std::string& answer) {
    return motion_refusal(moving(
        "first_contact", "{}", ",\n\"answer\": " + answer + R"(, "answered_by": {"engine": "x"})"));
  };
  EXPECT_EQ(answered(R"({"status": "hit", "low": 0.25, "high": 0.5})"), "");
  EXPECT_EQ(answered(R"({"status": "free", "low": 1, "high": 1})"), "");
  EXPECT_EQ(answered(R"({"status": "gone", "low": 0, "high": 1})"),
            "c:3: /answer/status: \"gone\" is none of free, hit and close");
  EXPECT_EQ(answered(R"({"status": "hit", "low": -0.5, "high": 1})"),
            "c:3: /answer/low: is no time from 0 to 1");
  EXPECT_EQ(answered(R"({"status": "hit", "low": 0.5, "high": 0.25})"),
            "c:3: /answer/low: is later than \"high\"");
  EXPECT_EQ(answered(R"({"status": "free", "low": 0.5, "high": 1})"),
            "c:3: /answer/low: is not 1, up to which all is free");
  EXPECT_EQ(answered(R"({"says": true})"),
            "c:3: /answer: unknown key \"says\"; there are status, low, high");
  EXPECT_EQ(answered(R"({"status": "hit", "low": 0})"), "c:3: /answer: has no \"high\"");
  EXPECT_EQ(motion_refusal(moving("free", "{}", R"(, "settings": {"tolerance": -1})")),
            "c:2: /settings/tolerance: is negative");
  EXPECT_EQ(motion_refusal(moving("free", "{}", R"(, "settings": {"limit": 1})")),
            "c:2: /settings/limit: only \"pairs\" and \"self_pairs\" have a limit");
  const std::string within =
      R"({"graze_case": 1, "question": "within", "settings": {"clearance": 1, "tolerance": 1}, "a": {"mesh": {"vertices": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [[0,1,2]]}}, "b": {"mesh": {"same_as": "a"}}})";
  EXPECT_EQ(motion_refusal(within),
            "c:1: /settings/tolerance: only \"first_contact\" and \"free\" have a tolerance");
}

}  // namespace
}  // namespace graze

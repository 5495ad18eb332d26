// `graze explain` of shapes, motions, rays and points: the words say what is so.

#include <graze/bvh/error.h>
#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/motion_case.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/cli/replay/case_list.h>
#include <graze/engine/cli/reports/case_explanation.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <string>

#include "tests/shapes/formula_meshes.h"

namespace graze::cli {
namespace {

Case body_case(Ask ask, const Shape& a, const Shape& b, double x) {
  Pose pose = Pose::Identity();
  pose.translation().x() = x;
  return {.note = "",
          .ask = ask,
          .settings = {.clearance = 0.25},
          .a = CaseBody(a, Pose::Identity()),
          .b = CaseBody(b, pose),
          .answer = CaseAnswer(),
          .answered_by = {"mine", "2"}};
}

/// All reasons, one after the other.
std::string reasons_in(const CaseExplanation& e) {
  std::string text;
  for (const std::string& each : e.reasons.value_or(Reasons()))
    text += each + "\n";
  return text;
}

void expect_in(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), text.npos) << part << " is not in\n" << text;
}

TEST(CliExplainReasons, ShapesThatAreApartHaveAPlaneAndTwoPoints) {
  Case query = body_case(Ask::Distance, Sphere{{0, 0, 0}, 1}, Box{{0.5, 1, 1}}, 2);
  query.answer->distance = 0.75;
  const CaseExplanation e = explain_case(query);
  EXPECT_EQ(e.judgement.verdict, compare::Verdict::Wrong);
  const std::string text = reasons_in(e);
  expect_in(text,
            "A plane parts them. Measured along the direction (1, 0, 0), all of A ends at 1 m "
            "and all of B begins at 1.5 m, so that a gap of 0.5 m is left");
  expect_in(text, "(1, 0, 0) on A and (1.5, 0, 0) on B are 0.5 m apart");
  expect_in(text, "The answer says 0.75 m.");
  expect_in(text, "The answer is off by 0.25 m.");
  expect_in(to_text(e), "The answer is wrong.");
  expect_in(to_json(e), "\"reasons\":[\"A plane parts them.");
  query.ask = Ask::Any;
  query.answer = CaseAnswer();
  query.answer->says = false;
  EXPECT_EQ(explain_case(query).why, "The answer is right.");
  expect_in(reasons_in(explain_case(query)), "a gap of 0.5 m is left");
  query.ask = Ask::Within;
  expect_in(reasons_in(explain_case(query)), "The clearance that was asked for is 0.25 m.");
}

TEST(CliExplainReasons, ShapesThatMeetShareAPoint) {
  Case query = body_case(Ask::Contacts, Box{{1, 1, 1}}, Box{{1, 0.5, 0.5}}, 1.75);
  query.answer->manifold.emplace().push_back(
      {{0.875, 0, 0}, std::nullopt, std::nullopt, {-1, 0, 0}, 0.25, {0, 0}});
  const CaseExplanation e = explain_case(query);
  EXPECT_EQ(e.judgement.verdict, compare::Verdict::Wrong);
  const std::string text = reasons_in(e);
  expect_in(text, "They share the point ");
  expect_in(text, "They are 0.25 m deep in each other: moved by that along (1, 0, 0), B is free");
  expect_in(text,
            "says that B must go 0.25 m along (-1, 0, 0); a plane across that direction parts them "
            "once it has gone 3.75 m.");
}

TEST(CliExplainReasons, OfMotionsTheFirstContactIsNamed) {
  const Mesh cube = tests::make_box({1, 1, 1});
  const RigidMotion rests{Pose::Identity()};
  const RigidMotion comes(Pose(Eigen::Translation3d(3, 0, 0)), {.shift = {-2, 0, 0}});
  Case query = to_case(case_mesh(cube, rests), case_mesh(cube, comes),
                       first_contact({cube, rests}, {cube, comes}));
  query.answer->low = query.answer->high = 0.75;
  query.answered_by = {"somebody", "1"};
  std::string text = reasons_in(explain_case(query));
  expect_in(text, "of the way, which begins at 0 and ends at 1, they are in contact.");
  expect_in(text, " share a point, exactly.");
  expect_in(text, "they are apart, which a certificate proves for every moment");
  expect_in(text, "The answer says that they meet at 0.75.");
  expect_in(text, "That is 0.25 of the way too late: until then the two go 0.5 m deep");
  query.answer->low = query.answer->high = 0.25;
  text = reasons_in(explain_case(query));
  expect_in(text, "That is 0.25 of the way too early: there they are 0.5 m apart.");
  query.answer->status = RigidStatus::Free;
  query.answer->low = query.answer->high = 1;
  expect_in(reasons_in(explain_case(query)), "That contact is missed");
  std::get<CaseMesh>(*query.b).course->shift = {0, 2, 0};
  query.answer->status = RigidStatus::Hit;
  text = reasons_in(explain_case(query));
  expect_in(text, "They never meet: that is proved for the whole way");
  expect_in(text, "There is no such contact");
}

TEST(CliExplainReasons, OfRaysAndPointsItSaysWhatTheyMeet) {
  const Mesh cube = tests::make_box({1, 1, 1});
  Case query{.note = "",
             .ask = Ask::Ray,
             .settings = {},
             .a = CaseMesh(cube, Pose::Identity()),
             .b = Ray{{-3, 0.25, 0.125}, {1, 0, 0}},
             .answer = CaseAnswer(),
             .answered_by = {"mine", ""}};
  query.answer->hits.emplace();
  CaseExplanation e = explain_case(query);
  EXPECT_EQ(e.judgement.verdict, compare::Verdict::Wrong);
  expect_in(reasons_in(e), "It first meets the surface in triangle ");
  expect_in(reasons_in(e), " after 2 m, at (-1, 0.25, 0.125), where the surface faces (-1, 0, 0).");
  expect_in(reasons_in(e), "The answer says that it meets nothing.");
  query.answer = answer_case(query);
  query.answer->hits->front().distance = 2.5;
  expect_in(reasons_in(explain_case(query)), "That is 0.5 m too far.");
  query.ask = Ask::Contains;
  query.b = CasePoint{{0.5, 0.25, 0.125}};
  query.answer = CaseAnswer();
  query.answer->says = false;
  e = explain_case(query);
  EXPECT_EQ(e.judgement.verdict, compare::Verdict::Wrong);
  expect_in(reasons_in(e), "The point (0.5, 0.25, 0.125) is inside, or on the surface.");
  expect_in(reasons_in(e), "along x meets the closed surface 1 time:");
}

/// Of two that meet, with the claim that this translation parts them.
Case moved_out(const CaseShape& a, const CaseShape& b, const Eigen::Vector3d& by) {
  Case query{.note = "",
             .ask = Ask::Separation,
             .settings = {},
             .a = a,
             .b = b,
             .answer = CaseAnswer(),
             .answered_by = {"mine", ""}};
  query.answer->distance = by.norm();
  query.answer->translation = by;
  return query;
}

TEST(CliExplainReasons, WaysOutOfMeshesAreGone) {
  Case query = moved_out(
      CaseMesh(tests::make_box({1, 1, 1}), Pose::Identity()),
      CaseMesh(tests::make_box({1, 1, 1}), Pose(Eigen::Translation3d(1.5, 0, 0))), {0.25, 0, 0});
  CaseExplanation e = explain_case(query);
  EXPECT_EQ(e.judgement.verdict, compare::Verdict::Wrong);
  expect_in(reasons_in(e), "The answer says that B is apart 0.25 m away, moved by (0.25, 0, 0).");
  expect_in(reasons_in(e), "Moved like that: Triangle ");
  expect_in(reasons_in(e), "The answer is off by 0.25 m.");
  query.answer = answer_case(query);
  e = explain_case(query);
  EXPECT_EQ(e.judgement.verdict, compare::Verdict::Right) << e.judgement.truth;
  expect_in(reasons_in(e), "Moved like that: The nearest triangles are ");
}

TEST(CliExplainReasons, WaysOutOfBodiesHaveTheShortestBesideThem) {
  const Case query =
      moved_out(CaseBody(Box{{1, 1, 1}}, Pose::Identity()),
                CaseBody(Box{{1, 0.5, 0.5}}, Pose(Eigen::Translation3d(1.75, 0, 0))), {0, 1.5, 0});
  const CaseExplanation e = explain_case(query);
  EXPECT_EQ(e.judgement.verdict, compare::Verdict::Wrong);
  expect_in(reasons_in(e), "The answer moves B by 1.5 m along (0, 1, 0).");
  expect_in(reasons_in(e), "A plane across that direction parts them once B has gone 1.5 m.");
  expect_in(reasons_in(e),
            "Of all directions that were tried (1, 0, 0) is the shortest: a plane "
            "across it parts them after 0.25 m.");
  expect_in(reasons_in(e),
            "Planes across all other directions prove that none is shorter than 0.25 m.");
  expect_in(reasons_in(e), "The answer is off by 1.25 m.");
}

TEST(CliExplainReasons, WhatIsNotExplainedIsSaid) {
  Case query{.note = "",
             .ask = Ask::Intersection,
             .settings = {},
             .a = CaseMesh(tests::make_box({1, 1, 1}), Pose::Identity()),
             .b = CaseMesh(tests::make_box({1, 1, 1}), Pose(Eigen::Translation3d(1, 0.5, 0.25))),
             .answer = std::nullopt,
             .answered_by = {"mine", ""}};
  query.answer = answer_case(query);
  query.answer->intersection->points.front().position.y() += 7;
  const CaseExplanation e = explain_case(query);
  EXPECT_EQ(e.judgement.verdict, compare::Verdict::Wrong);
  expect_in(e.why, "An answer to \"intersection\" about these is judged");
  expect_in(e.why, "but not explained");
}

/// Of every hard case something is said, whatever it asks: none is left without a word.
TEST(CliExplainReasons, EveryHardCaseIsGoneThrough) {
  std::size_t with_reasons = 0;
  for (const std::filesystem::path& file :
       case_files({std::string(GRAZE_DATA_DIR) + "/hard_cases"})) {
    read_listed_cases(
        file, {},
        [&](const ListedCase& each) {
          const CaseExplanation e = explain_case(each.query);
          EXPECT_EQ(e.judgement.verdict, compare::Verdict::Right) << each.name;
          EXPECT_EQ(e.why, "The answer is right.");
          if (!e.reasons) return;
          EXPECT_GE(e.reasons->size(), 2u) << each.name << reasons_in(e);
          ++with_reasons;
        },
        [](const Error& error) { ADD_FAILURE() << error.what(); });
  }
  EXPECT_GE(with_reasons, 27u + 11u + 7u) << "shapes, motions and rays";
}

}  // namespace
}  // namespace graze::cli

// The judge on trial: its arithmetic against other arithmetic, and the size and class of errors in
// answers that are wrong on purpose.

#include <graze/engine/cases/to_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/meshes/pair_error.h>
#include <graze/engine/compare/judge/rational/least_translation.h>
#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>
#include <graze/engine/compare/referee.h>
#include <graze/engine/compare/run/poses/pose_source.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/mesh/placement.h>
#include <gtest/gtest.h>
#include <tests/oracle/category.h>
#include <tests/oracle/sampler.h>
#include <algorithm>
#include <map>

#include "tests/compare/judge/judged.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze::compare {
namespace {

using Vector = Eigen::Vector3d;

void expect_gap_and_hit_agree(std::uint64_t step, std::uint64_t count) {
  std::size_t hits = 0;
  std::size_t all = 0;
  for (const auto& corpus : oracle::pair_corpora()) {
    for (std::uint64_t i = 0; i < count; ++i, ++all) {
      const oracle::TrianglePair pair = corpus.element(i * step);
      const bool is_hit = referee_intersects(pair.a, pair.b);
      const mpq_class gap = squared_distance(exactly(pair.a), exactly(pair.b));
      ASSERT_EQ(gap == 0, is_hit) << corpus.name() << " element " << i * step;
      if (!is_hit) {
        ASSERT_EQ(squared_depth(exactly(pair.a), exactly(pair.b)), 0) << corpus.name();
      }
      hits += is_hit;
    }
  }
  EXPECT_GT(hits, all / 20);
  EXPECT_LT(hits, all);
}

TEST(JudgeArithmetic, TheGapIsZeroExactlyWhereTheLinearProgramSaysHit) {
  expect_gap_and_hit_agree(97, 8);
}
TEST(JudgeArithmeticSlow, TheGapIsZeroExactlyWhereTheLinearProgramSaysHit) {
  expect_gap_and_hit_agree(1, 20000);
}

TEST(JudgeArithmetic, GapsAndDepthsAreThoseOfGeometry) {
  const auto gap = [](const Triangle& a, const Triangle& b) {
    return squared_distance(exactly(a), exactly(b));
  };
  EXPECT_EQ(gap(kFlat, moved(kFlat, Vector(0, 0, 3))), 9);
  EXPECT_EQ(gap(kFlat, moved(kFlat, Vector(-7, 0, 4))), 9 + 16);
  EXPECT_EQ(gap(kFlat, moved(kFlat, Vector(4, 4, 0))), 8) << "edge to corner, in one plane";
  const Triangle upright{{1, 1, -1}, {1, 1, 2}, {1, 2, 5}};
  EXPECT_EQ(gap(kFlat, upright), 0);
  EXPECT_EQ(squared_depth(exactly(kFlat), exactly(upright)), 1) << "up by one metre";
  EXPECT_EQ(squared_depth(exactly(kFlat), exactly(kFlat)), 0);
  const Triangle point{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}};
  EXPECT_EQ(squared_depth(exactly(kFlat), exactly(point)), 0);
  EXPECT_TRUE(has_no_area(exactly(point)));
  EXPECT_FALSE(has_no_area(exactly(kFlat)));
  EXPECT_EQ(rounded_root(mpq_class(9)), 3.0);
  EXPECT_EQ(root_error(2.5, mpq_class(9)), 0.5);
}

TEST(JudgeMeshes, TheTreeChangesNothing) {
  RandomSource source(7);
  for (int run = 0; run < 6; ++run) {
    const Mesh a = run % 2 == 0 ? tests::random_soup({.count = 14}, source)
                                : tests::lattice_soup(14, 2, source);
    const Mesh b = tests::random_soup({.count = 12, .centre = {run < 4 ? 0.5 : 5, 0, 0}}, source);
    const Pose pose = tests::random_pose(0.2, source);
    const MeshReferee referee({a}, {b, pose});
    std::vector<TrianglePair> hits;
    mpq_class gap = -1;
    for (std::uint32_t i = 0; i < a.triangles().size(); ++i) {
      for (std::uint32_t j = 0; j < b.triangles().size(); ++j) {
        if (referee.is_hit({i, j})) hits.push_back({i, j});
        const mpq_class square =
            squared_distance(exactly(a.triangle(i)), exactly(place(pose, b.triangle(j))));
        if (gap < 0 || square < gap) gap = square;
      }
    }
    EXPECT_EQ(referee.find_hits(), hits);
    EXPECT_EQ(referee.find_hit().has_value(), !hits.empty());
    EXPECT_EQ(referee.find_gap().square, gap);
    EXPECT_EQ(find_triangle_pairs({a}, {b, pose}).pairs, hits);
  }
}

TEST(JudgeClasses, TouchingIsAnErrorOfAFewUlps) {
  const Triangle above{{1, 1, 0x1p-50}, {1, 1, 5}, {2, 2, 5}};
  const Judgement judgement = judged(kFlat, above, true);
  EXPECT_EQ(judgement.verdict, Verdict::Wrong);
  EXPECT_EQ(judgement.error_class, ErrorClass::Touching);
  EXPECT_EQ(judgement.error, 0x1p-50);
  EXPECT_EQ(judgement.ulps, 1.0) << "of a coordinate of 5";
  EXPECT_EQ(judged(kFlat, above, false).verdict, Verdict::Right);
  EXPECT_EQ(judged(kFlat, moved(above, Vector(0, 0, -0x1p-49)), false).error_class,
            ErrorClass::Touching);
}

TEST(JudgeClasses, FarBeyondRoundingIsReal) {
  const Triangle above{{1, 1, 0x1p-20}, {1, 1, 5}, {2, 2, 5}};
  EXPECT_EQ(judged(kFlat, above, true).error_class, ErrorClass::Real);
  const Judgement missed = judged(kFlat, moved(above, Vector(0, 0, -1)), false);
  EXPECT_EQ(missed.error_class, ErrorClass::Real);
  EXPECT_GT(missed.error, 0.25);
}

TEST(JudgeClasses, TrianglesWithoutAreaAreDegenerate) {
  const Triangle segment{{1, 1, -1}, {1, 1, 1}, {1, 1, 0}};
  EXPECT_EQ(judged(kFlat, segment, false).error_class, ErrorClass::Degenerate);
}

TEST(JudgeClasses, OneInsideTheOtherIsContainment) {
  const Judgement judgement = judged(CaseMesh(tests::make_box({1, 1, 1}), Pose::Identity()),
                                     CaseMesh(tests::make_box({4, 4, 4}), Pose::Identity()), true);
  EXPECT_EQ(judgement.error_class, ErrorClass::Containment);
  EXPECT_EQ(judgement.error, 3.0);
}

Judgement judged_distance(const CaseShape& a, const CaseShape& b, double distance,
                          const char* engine = "somebody") {
  Case query = to_case(a, b, true);
  query.ask = Ask::Distance;
  CaseAnswer answer;
  answer.distance = distance;
  return Judge(query).judge(answer, {engine, ""});
}

TEST(JudgeClasses, ContainmentIsAClassOfEveryClaimOfATouch) {
  const CaseMesh inner(tests::make_box({1, 1, 1}), Pose::Identity());
  const CaseMesh outer(tests::make_box({4, 4, 4}), Pose::Identity());
  for (const double claimed : {0.0, -1.0}) {
    const Judgement judgement = judged_distance(inner, outer, claimed);
    EXPECT_EQ(judgement.verdict, Verdict::Wrong);
    EXPECT_EQ(judgement.error_class, ErrorClass::Containment) << claimed;
    EXPECT_EQ(judgement.error, 3.0);
  }
  EXPECT_EQ(judged_distance(inner, outer, 1).error_class, ErrorClass::Real) << "no claim of one";
  Case within = to_case(inner, outer, true);
  within.ask = Ask::Within;
  within.settings.clearance = 0.25;
  EXPECT_EQ(Judge(within).judge(*within.answer, {"somebody", ""}).error_class,
            ErrorClass::Containment);
}

TEST(JudgeDistances, ANegativeOneClaimsATouch) {
  const Triangle crossing{{1, 1, -1}, {1, 1, 2}, {1, 2, 5}};
  const Triangle above = moved(kFlat, Vector(0, 0, 3));
  for (const double claimed : {-1.0, -0.25, -7e5}) {
    EXPECT_EQ(judged_distance(kFlat, crossing, claimed).verdict,
              claimed == -1 ? Verdict::Right : Verdict::NotJudged)
        << "how deep has many definitions";
    const Judgement wrong = judged_distance(kFlat, above, claimed);
    EXPECT_EQ(wrong.verdict, Verdict::Wrong);
    EXPECT_EQ(wrong.error, 3) << "the gap, not the difference";
    EXPECT_EQ(judged_distance(kFlat, crossing, claimed, "graze").verdict, Verdict::Wrong);
  }
}

TEST(JudgeClasses, WhatOnlyThePoseHasRoundedIsPoseRounding) {
  // 1/3 above 1 is no double: placing moves the touching point off the face by a part of an ulp.
  Pose pose = Pose::Identity();
  pose.translation().z() = 0x1p-54;
  const std::array<Eigen::Vector3d, 3> corners = {Vector(1, 1, 1), Vector(1, 2, 3),
                                                  Vector(2, 1, 3)};
  const Mesh above(corners, std::array<TriangleIndices, 1>{{{0, 1, 2}}});
  const Triangle at_one = moved(kFlat, Vector(0, 0, 1));
  const Mesh flat(std::array<Eigen::Vector3d, 3>{at_one.a, at_one.b, at_one.c},
                  std::array<TriangleIndices, 1>{{{0, 1, 2}}});
  const Judgement judgement =
      judged(CaseMesh(flat, Pose::Identity()), CaseMesh(above, pose), false);
  EXPECT_EQ(judgement.verdict, Verdict::Wrong) << "law 1 places it on the face";
  EXPECT_EQ(judgement.error_class, ErrorClass::PoseRounding) << "in real numbers it is above";
}

// All pairs of triangles of cubes in line merely touch: what undoes the hit is what counts.
TEST(JudgeClasses, AMissedHitIsAsLargeAsTheTranslationThatParts) {
  for (const double x : {1.5, -1.5, 0.25}) {
    const Judgement missed = judged(cube_at(0), cube_at(x), false);
    EXPECT_EQ(missed.error_class, ErrorClass::Real) << x;
    EXPECT_EQ(missed.error, 2 - std::abs(x));
  }
  EXPECT_EQ(judged(cube_at(0), cube_at(0), false).error, 2) << "one and the same cube";
  EXPECT_EQ(judged(cube_at(0), cube_at(1.75, 0.125), false).error, 0.25);
  const Judgement face = judged(cube_at(0), cube_at(2), false);
  EXPECT_EQ(face.error_class, ErrorClass::Coplanar);
  EXPECT_EQ(face.error, 0);
  const Judgement deeper = judged(cube_at(0), cube_at(2 - 0x1p-50), false);
  EXPECT_EQ(deeper.error_class, ErrorClass::Coplanar) << "the sides of cubes in line";
  EXPECT_EQ(deeper.error, 0x1p-50);
  EXPECT_EQ(judged(cube_at(0), cube_at(2 - 0x1p-40), false).error_class, ErrorClass::Real);
  EXPECT_EQ(judged(cube_at(0), cube_at(2, 2), false).error_class, ErrorClass::Coplanar) << "edges";
}

/// A floor and a wall in one mesh: out of the corner leads a direction that no triangle is normal
/// to.
TEST(JudgeClasses, ACornerIsLeftAwayFromBothFaces) {
  const Mesh corner(std::vector<Eigen::Vector3d>{{-1, -3, -3},
                                                 {-1, 3, -3},
                                                 {-1, -3, 3},
                                                 {-1, 3, 3},
                                                 {5, -3, -1},
                                                 {5, 3, -1},
                                                 {-3, -3, -1},
                                                 {-3, 3, -1}},
                    std::vector<TriangleIndices>{{0, 1, 2}, {1, 3, 2}, {4, 5, 6}, {5, 7, 6}});
  const Judgement missed = judged(CaseMesh(corner, Pose::Identity()), cube_at(0), false);
  EXPECT_EQ(missed.error_class, ErrorClass::Coplanar) << "face on face";
  EXPECT_EQ(missed.error, 0);
}

TEST(JudgeClasses, AnEmptyListOrNoContactSaysThatTheyAreApart) {
  Case query = to_case(cube_at(0), cube_at(1.5), true);
  query.ask = Ask::Pairs;
  CaseAnswer none;
  none.pairs.emplace();
  const Judgement list = Judge(query).judge(none, {"somebody", ""});
  EXPECT_EQ(list.error_class, ErrorClass::Real);
  EXPECT_EQ(list.error, 0.5);
  EXPECT_GT(list.wrong_pairs, 8u);
  query.ask = Ask::Contacts;
  CaseAnswer no_contact;
  no_contact.contacts.emplace();
  EXPECT_EQ(Judge(query).judge(no_contact, {"somebody", ""}).error, 0.5);
}

/// The translation found separates: moved by a little more, two soups of triangles are apart, and
/// every pair needs at least its own depth.
TEST(JudgeClasses, TheWayOutIsNoShorterThanAnyPairNeeds) {
  RandomSource source(11);
  std::size_t hits = 0;
  for (int run = 0; run < 12; ++run) {
    const Mesh a = tests::random_soup({.count = 12, .extent = 0.4, .size = 0.4}, source);
    const Mesh b = tests::random_soup({.count = 12, .extent = 0.4, .size = 0.4}, source);
    const MeshReferee referee({a}, {b});
    const std::vector<TrianglePair> pairs = referee.find_hits();
    if (pairs.empty()) continue;
    ++hits;
    double deepest = 0;
    for (const TrianglePair& pair : pairs) {
      deepest = std::max(deepest, rounded_root(squared_depth(exactly(a.triangle(pair.a)),
                                                             exactly(b.triangle(pair.b)))));
    }
    LeastTranslation separating_translation(referee, pairs);
    const double length = separating_translation.find();
    EXPECT_GE(length, deepest * (1 - 0x1p-40));
    EXPECT_FALSE(separating_translation.find_within(deepest / 2));
    EXPECT_TRUE(separating_translation.find_within(length * (1 + 0x1p-40)));
  }
  EXPECT_GT(hits, 6u);
}

/// What a file claims is classed by the claim, not by an engine that happens to have its name.
TEST(JudgeClasses, ANameOfAClaimantChangesNothing) {
  const Triangle touching{{1, 1, 0}, {1, 2, 5}, {2, 1, 5}};
  for (const bool is_touching : {false, true}) {
    Case query = to_case(cube_at(0), cube_at(1.5), false);
    if (is_touching) {
      const auto mesh = [](const Triangle& t) {
        return Mesh(std::vector<Eigen::Vector3d>{t.a, t.b, t.c},
                    std::vector<TriangleIndices>{{0, 1, 2}});
      };
      Pose raised = Pose::Identity();
      raised.translation().z() = 1;
      query = to_case(CaseMesh(mesh(kFlat), raised), CaseMesh(mesh(touching), raised), false);
    }
    std::vector<ErrorClass> classes;
    for (const char* name : {"graze", "fcl", "bullet", "nobody"}) {
      query.answered_by = {name, ""};
      classes.push_back(try_case(query, all_engines()).front().judgement.error_class);
    }
    EXPECT_EQ(classes,
              std::vector<ErrorClass>(4, is_touching ? ErrorClass::Touching : ErrorClass::Real));
  }
}

/// One answer has one class: given by an engine that is asked, or read from a case.
TEST(JudgeClasses, AnAnswerHasOneClassLiveAndRecorded) {
  const Mesh torus = tests::make_torus(1, 0.25, 12, 8), ball = tests::make_sphere(0.5, 6, 8);
  const std::vector<EngineEntry> engines = all_engines();
  std::map<ErrorClass, std::size_t> classes;
  for (const Pose& pose : grazing_poses({torus}, ball, 60, 5)) {
    Case query = to_case(CaseMesh(torus, Pose::Identity()), CaseMesh(ball, pose), true);
    query.answer.reset();
    for (const Testimony& live : try_case(query, engines)) {
      if (!live.is_wrong()) continue;
      ++classes[live.judgement.error_class];
      Case kept = query;
      kept.answer = live.answer;
      for (const CaseWitness& witness : {live.witness, CaseWitness{"nobody", ""}}) {
        kept.answered_by = witness;
        const Judgement recorded = try_case(kept, {}).front().judgement;
        EXPECT_EQ(recorded.error_class, live.judgement.error_class)
            << live.witness.engine << ": " << name_of(recorded.error_class);
        EXPECT_EQ(recorded.error, live.judgement.error);
        EXPECT_EQ(recorded.truth, live.judgement.truth);
      }
    }
  }
  const bool has_peer = std::any_of(engines.begin(), engines.end(), [](const EngineEntry& e) {
    return e.engine != nullptr && (e.name == "fcl" || e.name == "bullet");
  });
  EXPECT_EQ(classes[ErrorClass::PoseRounding] > 0, has_peer);
}

/// Who brings B into A's frame by one pose rounds otherwise than who places both, and than nobody.
TEST(JudgeClasses, WhatOnePoseMadeOfTwoHasRoundedIsPoseRoundingToo) {
  const Mesh torus = tests::make_torus(1, 0.25, 12, 8), ball = tests::make_sphere(0.5, 6, 8);
  Pose turned = Pose::Identity();
  turned.linear() = Eigen::AngleAxisd(1, Vector(1, 2, 3).normalized()).toRotationMatrix();
  turned.translation() = Vector(3, -2, 1);
  std::size_t by_one_pose = 0;
  for (const Pose& pose : grazing_poses({torus, turned}, ball, 60, 5)) {
    const MeshReferee referee({torus, turned}, {ball, pose});
    const TrianglePair pair = referee.find_gap().pair;
    const bool is_hit = referee.find_gap().square == 0;
    const bool is_real_hit =
        squared_distance(placed_without_rounding(turned, torus.triangle(pair.a)),
                         placed_without_rounding(pose, ball.triangle(pair.b))) == 0;
    const bool is_due = is_due_to_placing({torus, turned}, {ball, pose}, pair, is_hit);
    if (is_real_hit != is_hit) {
      EXPECT_TRUE(is_due);
    } else {
      by_one_pose += is_due;
    }
  }
  EXPECT_GT(by_one_pose, 3u);
}

TEST(JudgeDistances, AreRightWithinTheirBoundsOnly) {
  const Triangle above = moved(kFlat, Vector(0, 0, 3));
  Case query{.note = "",
             .ask = Ask::Distance,
             .settings = {},
             .a = kFlat,
             .b = above,
             .answer = std::nullopt,
             .answered_by = {}};
  const Judge judge(query);
  const auto verdict = [&](double distance, const char* engine) {
    CaseAnswer answer;
    answer.distance = distance;
    return judge.judge(answer, {engine, ""}).verdict;
  };
  EXPECT_EQ(verdict(3, "graze"), Verdict::Right);
  EXPECT_EQ(verdict(3 + 0x1p-49, "graze"), Verdict::Right);
  EXPECT_EQ(verdict(3 + 0x1p-47, "graze"), Verdict::Wrong);
  EXPECT_EQ(verdict(3 + 0x1p-47, "other"), Verdict::Right);
  EXPECT_EQ(verdict(3.001, "other"), Verdict::Wrong);
  EXPECT_EQ(verdict(0, "graze"), Verdict::Wrong);
}

}  // namespace
}  // namespace graze::compare

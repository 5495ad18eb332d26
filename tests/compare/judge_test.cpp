// The judge on trial: its arithmetic against other arithmetic, its verdicts on answers that are
// wrong on purpose, and the shrinking of what it finds.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/judge/rational/rational_box.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>
#include <graze/engine/compare/judge/rational/separating_translation.h>
#include <graze/engine/compare/judge/shrink/shrink.h>
#include <graze/engine/compare/referee.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/volumes/obb_overlap.h>
#include <gtest/gtest.h>
#include <tests/oracle/category.h>
#include <tests/oracle/sampler.h>
#include <algorithm>

#include "tests/compare/engine_doubles.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze::compare {
namespace {

Eigen::Vector3d way(double x, double y, double z) {
  return {x, y, z};
}

Triangle moved(const Triangle& t, const Eigen::Vector3d& by) {
  return {t.a + by, t.b + by, t.c + by};
}

const Triangle kFlat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

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
  EXPECT_EQ(gap(kFlat, moved(kFlat, way(0, 0, 3))), 9);
  EXPECT_EQ(gap(kFlat, moved(kFlat, way(-7, 0, 4))), 9 + 16);
  EXPECT_EQ(gap(kFlat, moved(kFlat, way(4, 4, 0))), 8) << "edge to corner, in one plane";
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

/// The verdict on an answer with the wrong sign.
Judgement judged(const CaseShape& a, const CaseShape& b, bool says) {
  const Case query = to_case(a, b, says);
  return Judge(query).judge(*query.answer, {"somebody", ""});
}

TEST(JudgeClasses, TouchingIsAnErrorOfAFewUlps) {
  const Triangle above{{1, 1, 0x1p-50}, {1, 1, 5}, {2, 2, 5}};
  const Judgement judgement = judged(kFlat, above, true);
  EXPECT_EQ(judgement.verdict, Verdict::Wrong);
  EXPECT_EQ(judgement.error_class, ErrorClass::Touching);
  EXPECT_EQ(judgement.error, 0x1p-50);
  EXPECT_EQ(judgement.ulps, 1.0) << "of a coordinate of 5";
  EXPECT_EQ(judged(kFlat, above, false).verdict, Verdict::Right);
  EXPECT_EQ(judged(kFlat, moved(above, way(0, 0, -0x1p-49)), false).error_class,
            ErrorClass::Touching);
}

TEST(JudgeClasses, FarBeyondRoundingIsReal) {
  const Triangle above{{1, 1, 0x1p-20}, {1, 1, 5}, {2, 2, 5}};
  EXPECT_EQ(judged(kFlat, above, true).error_class, ErrorClass::Real);
  const Judgement missed = judged(kFlat, moved(above, way(0, 0, -1)), false);
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
  const Triangle above = moved(kFlat, way(0, 0, 3));
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
  const std::array<Eigen::Vector3d, 3> corners = {way(1, 1, 1), way(1, 2, 3), way(2, 1, 3)};
  const Mesh above(corners, std::array<TriangleIndices, 1>{{{0, 1, 2}}});
  const Triangle at_one = moved(kFlat, way(0, 0, 1));
  const Mesh flat(std::array<Eigen::Vector3d, 3>{at_one.a, at_one.b, at_one.c},
                  std::array<TriangleIndices, 1>{{{0, 1, 2}}});
  const Judgement judgement =
      judged(CaseMesh(flat, Pose::Identity()), CaseMesh(above, pose), false);
  EXPECT_EQ(judgement.verdict, Verdict::Wrong) << "law 1 places it on the face";
  EXPECT_EQ(judgement.error_class, ErrorClass::PoseRounding) << "in real numbers it is above";
}

CaseMesh cube_at(double x, double y = 0) {
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Vector3d(x, y, 0);
  return {tests::make_box({1, 1, 1}), pose};
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

/// A floor and a wall in one mesh: out of the corner leads a way that no triangle is normal to.
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

/// The translation found parts the two: moved by a little more, two soups of triangles are apart.
/// It is no shorter than what any one pair needs.
TEST(JudgeClasses, TheTranslationIsNoShorterThanAnyPairNeeds) {
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
    SeparatingTranslation translation(referee, pairs);
    const double length = translation.find();
    EXPECT_GE(length, deepest * (1 - 0x1p-40));
    EXPECT_FALSE(translation.find_within(deepest / 2));
    EXPECT_TRUE(translation.find_within(length * (1 + 0x1p-40)));
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

TEST(JudgeDistances, AreRightWithinTheirBoundsOnly) {
  const Triangle above = moved(kFlat, way(0, 0, 3));
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

TEST(JudgeVolumes, AreJudgedWhereTheyArePromisedToBeExact) {
  const Sphere ball{{0, 0, 3}, 3};
  EXPECT_EQ(judged(kFlat, ball, false).verdict, Verdict::Wrong);
  EXPECT_EQ(judged(kFlat, Sphere{{0, 0, 3}, 0x1.7ffffffffffffp+1}, true).verdict, Verdict::Wrong);
  EXPECT_EQ(judged(kFlat, Aabb{{1, 1, 0}, {1, 1, 1}}, true).verdict, Verdict::Right);
  EXPECT_EQ(judged(kFlat, Obb{Pose::Identity(), {1, 1, 1}}, false).verdict, Verdict::Wrong);
  EXPECT_EQ(judged(ball, Aabb{{0, 0, 0}, {1, 1, 1}}, true).verdict, Verdict::Right);
}

TEST(JudgeVolumes, TheSizeOfAnErrorAndItsClass) {
  const Sphere ball{{0, 0, 0}, 1};
  const auto expect = [](const Judgement& judgement, ErrorClass error_class, double error) {
    EXPECT_EQ(judgement.verdict, Verdict::Wrong);
    EXPECT_EQ(judgement.error_class, error_class);
    EXPECT_EQ(judgement.error, error);
  };
  expect(judged(ball, Sphere{{2, 0, 0}, 1}, false), ErrorClass::Touching, 0);
  expect(judged(ball, Sphere{{1.5, 0, 0}, 1}, false), ErrorClass::Real, 0.5);
  expect(judged(ball, Sphere{{3, 4, 0}, 1}, true), ErrorClass::Real, 3);
  const Aabb box{{-1, -1, -1}, {1, 1, 1}};
  expect(judged(Sphere{{4, 5, 0}, 1}, box, true), ErrorClass::Real, 4);
  expect(judged(Sphere{{0.75, 0, 0}, 1}, box, false), ErrorClass::Real, 1.25);
  expect(judged(Sphere{{1.75, 0, 0}, 1}, box, false), ErrorClass::Real, 0.25);
  expect(judged(Sphere{{1.75, 0, 0}, 1}, Obb{Pose::Identity(), {1, 1, 1}}, false), ErrorClass::Real,
         0.25);
  expect(judged(box, Aabb{{4, 5, 0}, {6, 6, 6}}, true), ErrorClass::Real, 5);
  expect(judged(box, Aabb{{0.5, 0, 0}, {6, 6, 6}}, false), ErrorClass::Real, 0.5);
  expect(judged(kFlat, Sphere{{1, 1, 2}, 1}, true), ErrorClass::Real, 1);
  expect(judged(kFlat, Sphere{{1, 1, 0.5}, 1}, false), ErrorClass::Real, 0.5);
  expect(judged(kFlat, Aabb{{0, 0, 2}, {1, 1, 3}}, true), ErrorClass::Real, 2);
  expect(judged(kFlat, Aabb{{1, 1, -0.25}, {2, 1.5, 3}}, false), ErrorClass::Real, 0.25);
}

TEST(JudgeVolumes, OfMeshes) {
  const CaseMesh cube = cube_at(0);
  const Judgement far = judged(cube, Sphere{{3, 0, 0}, 1}, true);
  EXPECT_EQ(far.error_class, ErrorClass::Real);
  EXPECT_EQ(far.error, 1);
  EXPECT_EQ(judged(cube, Sphere{{2, 0, 0}, 1}, false).error_class, ErrorClass::Touching);
  const Judgement inside = judged(cube, Sphere{{0, 0, 0}, 0.25}, true);
  EXPECT_EQ(inside.error_class, ErrorClass::Containment);
  EXPECT_EQ(inside.error, 0.75);
  EXPECT_EQ(judged(cube, Aabb{{0, 0, 0}, {0.5, 0.5, 0.5}}, true).error_class,
            ErrorClass::Containment);
  const Judgement same = judged(cube, Aabb{{-1, -1, -1}, {1, 1, 1}}, false);
  EXPECT_EQ(same.error_class, ErrorClass::Real) << "though each triangle merely touches";
  EXPECT_EQ(same.error, 2);
  EXPECT_EQ(judged(cube, Aabb{{1, -1, -1}, {2, 1, 1}}, false).error_class, ErrorClass::Touching);
  Case list = to_case(cube, Sphere{{2, 0, 0}, 1}, true);
  list.ask = Ask::Pairs;
  CaseAnswer none;
  none.triangles.emplace();
  const Judgement missed = Judge(list).judge(none, {"somebody", ""});
  EXPECT_EQ(missed.error_class, ErrorClass::Touching);
  EXPECT_EQ(std::to_string(missed.wrong_pairs) + " triangles", missed.truth);
}

Obb turned_box(double x, double half) {
  Obb box{Pose::Identity(), Eigen::Vector3d::Constant(half)};
  box.pose.linear() << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1;
  box.pose.translation().x() = x;
  return box;
}

TEST(JudgeVolumes, OrientedBoxesAreJudgedAsTheirDoublesSay) {
  const Obb still{Pose::Identity(), {1, 1, 1}};
  Obb half = still;
  half.pose.translation().x() = 1.5;
  const Judgement missed = judged(still, half, false);
  EXPECT_EQ(missed.verdict, Verdict::Wrong);
  EXPECT_EQ(missed.error_class, ErrorClass::Real);
  EXPECT_EQ(missed.error, 0.5);
  EXPECT_EQ(judged(still, half, true).verdict, Verdict::Right);
  // Turned by the angle of 3, 4 and 5 a cube reaches 1.4 along x.
  EXPECT_EQ(judged(still, turned_box(2.375, 1), false).verdict, Verdict::Wrong);
  const Judgement invented = judged(still, turned_box(2.5, 1), true);
  EXPECT_EQ(invented.error_class, ErrorClass::Real);
  EXPECT_NEAR(invented.error, 0.1, 1e-15);
  EXPECT_EQ(judged(Aabb{{-1, -1, -1}, {1, 1, 1}}, turned_box(2.5, 1), false).verdict,
            Verdict::Right);
  Case query = to_case(CaseShape(still), CaseShape(turned_box(2.5, 1)), true);
  EXPECT_EQ(Judge(query).judge(*query.answer, {"graze", ""}).verdict, Verdict::NotJudged)
      << "only apart is promised";
  EXPECT_EQ(judged(still, turned_box(1, 0), false).error_class, ErrorClass::Touching)
      << "a point on a face";
  EXPECT_EQ(judged(still, turned_box(1.5, 0), true).error, 0.5);
}

/// What separates by one method does by the other, and graze's boxes that are apart are.
TEST(JudgeVolumes, OverlapsAndGapsAgree) {
  RandomSource source(5);
  std::size_t hits = 0;
  for (int run = 0; run < 40; ++run) {
    const Obb a{tests::random_pose(1, source), {0.5, 0.75, run % 5 == 0 ? 0 : 0.25}};
    const Obb b{tests::random_pose(1, source), {0.25, 0.5, 0.75}};
    const std::optional<mpq_class> overlap = squared_overlap(exactly(a), exactly(b));
    EXPECT_EQ(squared_overlap(exactly(b), exactly(a)), overlap);
    const bool do_faces_meet = squared_gap(exactly(a), exactly(b)) == 0;
    hits += overlap.has_value();
    if (do_faces_meet) {
      EXPECT_TRUE(overlap);
    }
    if (!overlaps(a, b)) {
      EXPECT_FALSE(overlap);
    }
    if (!overlap) {
      EXPECT_GT(squared_gap(exactly_by_frame(a), exactly_by_frame(b)), 0);
    }
  }
  EXPECT_GT(hits, 4u);
  EXPECT_LT(hits, 36u);
}

TEST(JudgeWitnesses, PointsOfADistanceLieOnTheSurfacesAndAreSoFarApart) {
  Case query = to_case(kFlat, moved(kFlat, way(0, 0, 1)), true);
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
    answer.contacts = {{way(0.75, 0, 0), way(1, 0, 0), way(0.5, 0, 0), normal, depth}};
    return judge.judge(answer, {"somebody", ""});
  };
  const Judgement right = judgement({1, 0, 0}, 0.5);
  EXPECT_EQ(right.verdict, Verdict::Right);
  EXPECT_EQ(right.truth, "hit");
  EXPECT_EQ(judgement({1, 0, 0}, 7).verdict, Verdict::Wrong);
  EXPECT_EQ(judgement({1, 0, 0}, 7).error, 3.5) << "3.5 m are the longest way out along x";
  EXPECT_EQ(judgement({0, 1, 0}, 0.5).error, 0.5)
      << "at right angles to the way between the points";
  EXPECT_EQ(judgement({2, 0, 0}, 0.5).error, 1);
  EXPECT_EQ(judge.judge(answer_case(query), this_library()).verdict, Verdict::Right);
  for (const EngineEntry& entry : all_engines()) {
    if (entry.engine == nullptr) continue;
    const std::optional<CaseAnswer> answer = ask(*entry.engine, query);
    if (!answer) continue;
    EXPECT_NE(judge.judge(*answer, entry.engine->name()).verdict, Verdict::Wrong) << entry.name;
  }
}

/// Two bodies that meet, for engines with planted bugs.
class PlantedBug : public testing::Test {
 protected:
  PlantedBug() { pose_.translation() << 1.25, 0.125, 0.0625; }

  /// Finds, classifies and shrinks what the engine gets wrong, writes it and asks again.
  Case found(const Engine& engine, Ask ask_what, ErrorClass expected) {
    Case query = to_case({torus_}, {sphere_, pose_}, true);
    query.ask = ask_what;
    query.answer.reset();
    const StillWrong is_still_wrong = [&](const Case& smaller) {
      const std::optional<CaseAnswer> answer = ask(engine, smaller);
      return answer && Judge(smaller).judge(*answer, engine.name()).verdict == Verdict::Wrong;
    };
    EXPECT_TRUE(is_still_wrong(query));
    const Judgement judgement = Judge(query).judge(*ask(engine, query), engine.name());
    EXPECT_EQ(judgement.error_class, expected);
    Case small = shrink(query, judgement.culprit, is_still_wrong);
    EXPECT_TRUE(is_still_wrong(small)) << "shrinking lost the disagreement";
    small.answer = ask(engine, small);
    small.answered_by = engine.name();
    const Case back = parse_case(to_json(small), "memory");
    const std::vector<Testimony> all = try_case(back, all_engines());
    EXPECT_TRUE(all.front().is_recorded);
    EXPECT_EQ(all.front().judgement.verdict, Verdict::Wrong);
    EXPECT_EQ(all.at(1).judgement.verdict, Verdict::Right) << "graze";
    return back;
  }

  static std::size_t triangles_of(const Case& query) {
    return as_meshes(query)->a.mesh.triangles().size() +
           as_meshes(query)->b.mesh.triangles().size();
  }

  Mesh torus_ = tests::make_torus(1, 0.3, 12, 8);
  Mesh sphere_ = tests::make_sphere(0.5, 6, 9);
  Pose pose_ = Pose::Identity();
};

TEST_F(PlantedBug, AWrongSignIsFoundClassifiedShrunkAndReplayed) {
  pose_.translation() << 1.25, 0.5, 0.0625;
  const std::unique_ptr<Engine> engine = make_wrong_sign_engine("fcl");
  EXPECT_EQ(triangles_of(found(*engine, Ask::Pairs, ErrorClass::Real)), 2u);
  pose_.translation() << 0.5, 0, 0.75;
  Mesh box = tests::make_box({0.25, 0.25, 0.25});
  torus_ = tests::make_box({1, 1, 0.5});
  torus_ = Mesh(std::vector<Eigen::Vector3d>{{0.25, -1, 0.75}, {0.75, -1, 0.75}, {0.5, 1, 0.75}},
                std::vector<TriangleIndices>{{0, 1, 2}});
  sphere_ = box;
  EXPECT_LE(triangles_of(found(*engine, Ask::Any, ErrorClass::Real)), 2u);
}

TEST_F(PlantedBug, AVolumeThatIsRoundedInwardsIsFoundToo) {
  const std::unique_ptr<Engine> engine = make_inward_rounding_engine("graze", 0.01);
  EXPECT_EQ(triangles_of(found(*engine, Ask::Pairs, ErrorClass::Real)), 2u);
}

TEST(Shrinking, KeepsTheDisagreementWhateverItIs) {
  RandomSource source(3);
  for (int run = 0; run < 8; ++run) {
    const Mesh a = tests::random_soup({.count = 40, .extent = 0.5}, source);
    const Mesh b = tests::random_soup({.count = 40, .extent = 0.5}, source);
    const Case query = to_case({a}, {b, tests::random_pose(0.3, source)}, true);
    const auto least = static_cast<std::size_t>(run % 4 + 1);
    // "There are at least so many pairs": a property that needs more than two triangles.
    const StillWrong holds = [&](const Case& smaller) {
      const MeshCase meshes = *as_meshes(smaller);
      return find_triangle_pairs({meshes.a.mesh, meshes.a.pose}, {meshes.b.mesh, meshes.b.pose})
                 .size() >= least;
    };
    ASSERT_TRUE(holds(query));
    const Case small = shrink(query, std::nullopt, holds);
    EXPECT_TRUE(holds(small));
    const MeshCase meshes = *as_meshes(small);
    EXPECT_LE(meshes.a.mesh.triangles().size() + meshes.b.mesh.triangles().size(), 2 * least);
  }
}

}  // namespace
}  // namespace graze::compare

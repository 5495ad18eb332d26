// `graze explain`: what it says is so.

#include <fmt/format.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/cli/reports/case_explanation.h>
#include <graze/engine/cli/reports/explanation.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/triangle_pair/crossing_stages.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/shapes/formula_meshes.h"

namespace graze::cli {
namespace {

class CliExplain : public testing::Test {
 protected:
  Explanation at(double x) {
    pose_.translation() << x, 0.125, 0.0625;
    return explain({torus_}, {box_, pose_});
  }

  Mesh torus_ = tests::make_torus(1, 0.25, 20, 12);
  Mesh box_ = tests::make_box({0.5, 0.5, 0.5});
  Pose pose_ = Pose::Identity();
};

TEST_F(CliExplain, AHitHasAWitness) {
  const Explanation hit = at(1);
  EXPECT_TRUE(hit.intersects);
  const TrianglePairs pairs = find_triangle_pairs({torus_}, {box_, pose_});
  EXPECT_TRUE(std::binary_search(pairs.begin(), pairs.end(), hit.pair));
  EXPECT_EQ(hit.gap, 0);
  EXPECT_EQ(hit.point_a, hit.point_b);
  EXPECT_FALSE(hit.axis);
  EXPECT_LT(hit.widest.gap, 0);
  EXPECT_NE(to_text(hit).find("witness point"), std::string::npos);
}

TEST_F(CliExplain, AMissHasTheAxisOfThePairThatCameClosest) {
  const Explanation miss = at(2.5);
  EXPECT_FALSE(miss.intersects);
  const MeshDistance gap = distance({torus_}, {box_, pose_});
  EXPECT_EQ(miss.pair, gap.pair);
  EXPECT_EQ(miss.gap, gap.distance);
  const Triangle a = torus_.triangle(miss.pair.a);
  const Triangle b = place(pose_, box_.triangle(miss.pair.b));
  const auto along = [&](const Eigen::Vector3d& p) { return miss.axis->dot(p); };
  const double low_b = std::min({along(b.a), along(b.b), along(b.c)});
  const double high_a = std::max({along(a.a), along(a.b), along(a.c)});
  EXPECT_NEAR(low_b - high_a, gap.distance, 1e-14);
  EXPECT_EQ(miss.widest.name, "x of A");
  EXPECT_NEAR(miss.widest.gap, 2.5 - 1.25 - 0.5, 1e-12);
  EXPECT_EQ(miss.decider, Decider::MeshBoxes);
  EXPECT_NE(to_text(miss).find("the boxes around the meshes alone"), std::string::npos);
  ASSERT_TRUE(miss.boxes);
  EXPECT_EQ(miss.boxes->triangles_a, torus_.triangles().size());
}

TEST_F(CliExplain, TheBoxesThatAreApartHoldThePair) {
  int below_the_roots = 0;
  const Mesh grain = tests::make_box({0.02, 0.02, 0.02});
  for (const Eigen::Vector3d& shift : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.3, 0.2, 0),
                                       Eigen::Vector3d(0.2, -0.4, 0.1), Eigen::Vector3d(3, 0, 0)}) {
    pose_.translation() = shift;
    const Explanation miss = explain({torus_}, {grain, pose_});
    ASSERT_TRUE(miss.boxes);
    const BoxAxis& axis = miss.boxes->axis;
    const Triangle a = torus_.triangle(miss.pair.a);
    const Triangle b = place(pose_, grain.triangle(miss.pair.b));
    const auto along = [&](const Eigen::Vector3d& p) { return axis.direction.dot(p); };
    const auto [low_a, high_a] = std::minmax({along(a.a), along(a.b), along(a.c)});
    const auto [low_b, high_b] = std::minmax({along(b.a), along(b.b), along(b.c)});
    EXPECT_GE(std::max(low_a - high_b, low_b - high_a), axis.gap - 1e-6);
    EXPECT_GT(axis.gap, 0);
    below_the_roots += miss.boxes->triangles_a < torus_.triangles().size();
  }
  EXPECT_GE(below_the_roots, 2);
}

TEST_F(CliExplain, WhatIsInsideHasNoBoxesThatAreApart) {
  const Mesh grain = tests::make_box({0.02, 0.02, 0.02});
  pose_.translation() << 1, 0.01, 0;  // in the tube of the torus
  const Explanation inside = explain({torus_}, {grain, pose_});
  EXPECT_FALSE(inside.intersects);
  EXPECT_NE(inside.decider, Decider::MeshBoxes);
  ASSERT_TRUE(inside.solids);
  EXPECT_EQ(*inside.solids, Solids::Meet);
  EXPECT_NE(to_text(inside).find("a part of one lies inside the other"), std::string::npos);
  pose_.translation() << 0, 0, 0;  // in its hole
  EXPECT_EQ(explain({torus_}, {grain, pose_}).solids, Solids::Apart);
}

// An edge an ulp over a plane: what decides is not a volume, and the words must not say so.
TEST_F(CliExplain, AMissThatOnlyExactArithmeticSeesSaysSo) {
  const auto mesh_of = [](std::vector<Eigen::Vector3d> corners) {
    return Mesh(corners, std::vector<TriangleIndices>{{0, 1, 2}});
  };
  const Mesh floor = mesh_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 1}});
  const double up = std::nextafter(0.25, 1);
  const Mesh edge = mesh_of({{1, 1, up}, {2, 1, 0.25 + 1e-9}, {1, 1, 2}});
  const Explanation miss = explain({floor}, {edge});
  EXPECT_FALSE(miss.intersects);
  const Work& work = miss.volumes.front().work;
  EXPECT_EQ(miss.decider == Decider::Exact, work.exact_tests > 0);
  EXPECT_EQ(miss.decider, Decider::Exact);
  EXPECT_NE(to_text(miss).find("1 of them exact"), std::string::npos);
  EXPECT_FALSE(miss.solids);  // they are open
}

TEST_F(CliExplain, JsonSaysTheSame) {
  const Explanation miss = at(2.5);
  const std::string name = "out";
  const cases::JsonValue tree = cases::parse_json(to_json(miss), name);
  const cases::JsonCursor root(tree, name);
  EXPECT_FALSE(root.member("intersects").boolean());
  EXPECT_EQ(root.member("gap").number(), miss.gap);
  EXPECT_EQ(root.member("axis").point(), *miss.axis);
  const cases::JsonCursor volumes = root.member("volumes");
  for (const PairVolume volume : kPairVolumes)
    EXPECT_GT(volumes.member(graze::name_of(volume)).member("volume_tests").number(), 0);
}

Case two_triangles(const Triangle& a, const Triangle& b, bool says) {
  Case query{.note = "",
             .ask = Ask::Any,
             .settings = {},
             .a = a,
             .b = b,
             .answer = CaseAnswer(),
             .answered_by = {"mine", "2"}};
  query.answer->says = says;
  return query;
}

std::string regression(const char* name) {
  return std::string(GRAZE_DATA_DIR) + "/regressions/" + name;
}

TEST(CliExplainCase, RecordedAnswersAreGoneThrough) {
  for (const char* name : {"fcl-rock-14.json", "fcl-gear-15.json", "fcl-link-28.json"}) {
    const CaseExplanation e = explain_case(read_case(regression(name)));
    EXPECT_EQ(e.judgement.verdict, compare::Verdict::Wrong) << name;
    ASSERT_EQ(e.variants.size(), 6u) << name;
    EXPECT_EQ(e.variants[0].placed_touch, e.says == "no") << "law 1's own placing is the truth";
    EXPECT_FALSE(e.why.empty());
  }
}

/// A corner that is 2^-50 m off the plane of a triangle a metre away from the origin: the sign of
/// its determinant is lost in float.
TEST(CliExplainCase, ALostSignIsNamed) {
  const Triangle a{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  const Triangle b{{0.25, 0.25, 1 + 0x1p-40}, {0.25, 0.5, 2}, {0.5, 0.25, 2}};
  const CaseExplanation e = explain_case(two_triangles(a, b, true));
  EXPECT_EQ(e.judgement.verdict, compare::Verdict::Wrong);
  EXPECT_FALSE(e.variants[0].placed_touch);
  EXPECT_FALSE(e.variants[0].axes.says);
  EXPECT_TRUE(e.variants[3].placed_touch) << "as floats they do touch";
  EXPECT_NE(e.why.find("Placing does it"), e.why.npos) << e.why;
  EXPECT_NE(e.why.find("float"), e.why.npos);
  EXPECT_NE(to_json(e).find("\"verdict\":\"wrong\""), std::string::npos);
}

/// So near to a touch float is no explanation by itself.
TEST(CliExplainCase, FloatIsNotBlamedForWhatDoubleRounds) {
  const CaseExplanation e = explain_case(read_case(regression("fcl-link-28.json")));
  EXPECT_EQ(e.why.find("None of these textbook tests gives that answer in double"), 0u) << e.why;
  EXPECT_NE(e.why.find("if the engine computes in float: Placing does it"), e.why.npos) << e.why;
}

/// The axis that rounding hides.
TEST(CliExplainCase, AnOverlookedGapIsNamed) {
  Case query = read_case(regression("triangles-16.json"));
  query.answer->says = true;
  query.answered_by = {"mine", ""};
  const CaseExplanation e = explain_case(query);
  EXPECT_NE(e.why.find("The separating axis test"), e.why.npos) << e.why;
  EXPECT_NE(e.why.find("the gap along B's normal comes out as "), e.why.npos) << e.why;
  EXPECT_NE(e.why.find("overlooks the gap"), e.why.npos) << e.why;
}

TEST(CliExplainCase, ARightAnswerIsRightAndAnAbsurdOneIsNobodysRounding) {
  const Triangle a{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Triangle b{{0, 0, 3}, {1, 0, 3}, {0, 1, 3}};
  EXPECT_EQ(explain_case(two_triangles(a, b, false)).why, "The answer is right.");
  const CaseExplanation e = explain_case(two_triangles(a, b, true));
  EXPECT_NE(e.why.find("None of these textbook tests"), e.why.npos) << e.why;
  EXPECT_FALSE(e.pair.has_value() && e.variants.empty());
}

/// Steps of each test beside rational numbers: what both decide exactly is what the referee says,
/// whatever rounding does to what is computed.
TEST(CliExplainCase, BothTestsAreRightWhereNothingIsRounded) {
  std::uint64_t bits = 7;
  const auto whole = [&] {
    bits = bits * 6364136223846793005 + 1442695040888963407;
    return static_cast<double>(static_cast<std::int64_t>(bits >> 61) - 3);
  };
  const auto corner = [&] {
    const double x = whole(), y = whole(), z = whole();
    return Eigen::Vector3d(x, y, z);
  };
  std::size_t hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const Triangle a{corner(), corner(), corner()};
    const Triangle b{corner(), corner(), corner()};
    if ((a.b - a.a).cross(a.c - a.a).isZero() || (b.b - b.a).cross(b.c - b.a).isZero()) continue;
    const bool truth = intersects(a, b, Touch::Include);
    hits += truth;
    for (const auto test : {compare::ClassicTest::Axes, compare::ClassicTest::Determinants}) {
      for (const auto numbers : {compare::ClassicNumbers::Double, compare::ClassicNumbers::Float}) {
        const compare::ClassicRun run = compare::run_classic(test, numbers, a, b);
        ASSERT_EQ(run.says, truth) << i;
        for (const compare::ClassicStep& step : run.steps)
          ASSERT_EQ(step.computed, step.exact) << step.name;
      }
    }
  }
  EXPECT_GT(hits, 30u);
}

/// The regressions of the narrow phase, with the opposite of the truth: each is either blamed on a
/// step whose sign is wrong, or on nothing.
TEST(CliExplainCase, BlamedStepsHaveWrongSigns) {
  std::size_t blamed = 0;
  for (int i = 1; i <= 27; ++i) {
    const std::string name = fmt::format("triangles-{:02}.json", i);
    Case query = read_case(regression(name.c_str()));
    query.answer->says = !*query.answer->says;
    query.answered_by = {"mine", ""};
    const CaseExplanation e = explain_case(query);
    ASSERT_EQ(e.judgement.verdict, compare::Verdict::Wrong) << name;
    for (const compare::ClassicVariant& variant : e.variants) {
      for (const compare::ClassicRun* run : {&variant.axes, &variant.determinants}) {
        const compare::ClassicStep* step = run->misleading(variant.placed_touch);
        if (step == nullptr) continue;
        EXPECT_NE(step->computed_sign, step->exact_sign) << name << step->name;
        ++blamed;
      }
    }
  }
  EXPECT_GT(blamed, 5u);
}

}  // namespace
}  // namespace graze::cli

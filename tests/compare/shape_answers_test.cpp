// What engines say of the distance and the contacts of two shapes, and whether they are within a
// clearance, before the judge: bounds from below and above, tolerances, words.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/compare/judge/bodies/distance_bounds.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/peers/engine.h>
#include <gtest/gtest.h>
#include <cmath>
#include <limits>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_source.h"

namespace graze::compare {
namespace {

Case of_bodies(Ask ask, const Shape& a, const Shape& b, const Eigen::Vector3d& at_b,
               double clearance = 0) {
  Pose pose = Pose::Identity();
  pose.translation() = at_b;
  return {.note = "",
          .ask = ask,
          .settings = {.clearance = clearance},
          .a = CaseBody(a, Pose::Identity()),
          .b = CaseBody(b, pose),
          .answer = std::nullopt,
          .answered_by = {}};
}

Judgement on_distance(const Case& query, double distance, const char* engine = "other") {
  CaseAnswer answer;
  answer.distance = distance;
  return Judge(query).judge(answer, {engine, ""});
}

Judgement on_within(Case query, double clearance, bool says, const char* engine = "other") {
  query.ask = Ask::Within;
  query.settings.clearance = clearance;
  CaseAnswer answer;
  answer.says = says;
  return Judge(query).judge(answer, {engine, ""});
}

struct Known {
  const char* name;
  Shape a;
  Shape b;
  double at_x;      // where B stands
  double distance;  // by hand
};

std::vector<Known> known_distances() {
  const std::vector<Eigen::Vector3d> corners = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                                {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  return {{"balls", Sphere{{0, 0, 0}, 1}, Sphere{{0, 0, 0}, 0.5}, 2, 0.5},
          {"ball and box", Sphere{{0, 0, 0}, 1}, Box{{0.5, 1, 1}}, 2, 0.5},
          {"boxes", Box{{1, 1, 1}}, Box{{0.5, 0.25, 1}}, 2.25, 0.75},
          {"capsule and cylinder", Capsule{0.5, 1}, Cylinder{0.25, 1}, 1.75, 1},
          {"hull and ellipsoid", ConvexHull(corners), Ellipsoid{{0, 0, 0}, {0.5, 1, 1}}, 2, 0.5},
          {"half-space and ball", HalfSpace{{1, 0, 0}, 0.25}, Sphere{{0, 0, 0}, 0.5}, 1, 0.25}};
}

/// Both bounds hold the distance that is known by hand, and the words have them.
TEST(ShapeAnswers, BoundsHoldWhatIsKnown) {
  for (const Known& each : known_distances()) {
    SCOPED_TRACE(each.name);
    const Case query = of_bodies(Ask::Distance, each.a, each.b, {each.at_x, 0, 0});
    const BodyCase bodies = *as_bodies(query);
    const DistanceBounds bounds =
        distance_bounds({bodies.a.shape, bodies.a.pose}, {bodies.b.shape, bodies.b.pose});
    EXPECT_NEAR(bounds.least, each.distance, 1e-8);
    EXPECT_NEAR(bounds.most, each.distance, 1e-8);
    EXPECT_LE(bounds.least, each.distance + 1e-14);
    EXPECT_EQ(bounds.is_exact, std::string(each.name) == "balls");
    for (const double off : {0.01, -0.01, 1e-5, -1e-5}) {
      const Judgement judgement = on_distance(query, each.distance + off);
      EXPECT_EQ(judgement.verdict, Verdict::Wrong) << off;
      EXPECT_NEAR(judgement.error, std::abs(off), 1e-8);
      EXPECT_EQ(judgement.error_class, ErrorClass::Real);
      if (bounds.is_exact) continue;
      EXPECT_NE(judgement.truth.find("a plane proves"), std::string::npos) << judgement.truth;
      EXPECT_NE(judgement.truth.find("two points"), std::string::npos) << judgement.truth;
    }
    EXPECT_EQ(on_distance(query, each.distance + 1e-7).error_class, ErrorClass::Touching);
    EXPECT_EQ(on_distance(query, each.distance).verdict, Verdict::Right);
    EXPECT_EQ(on_distance(query, -1).verdict, Verdict::Wrong) << "a touch is claimed";
    EXPECT_EQ(on_distance(query, 0).verdict, Verdict::Wrong);
  }
}

TEST(ShapeAnswers, ANegativeDistanceOfAnotherEngineClaimsATouch) {
  const Case deep = of_bodies(Ask::Distance, Box{{1, 1, 1}}, Cone{1, 1}, {0.5, 0, 0});
  EXPECT_EQ(on_distance(deep, -1).verdict, Verdict::Right);
  EXPECT_EQ(on_distance(deep, 0).verdict, Verdict::Right);
  const Judgement depth = on_distance(deep, -0.25);
  EXPECT_EQ(depth.verdict, Verdict::NotJudged);
  EXPECT_NE(depth.truth.find("how deep"), std::string::npos) << depth.truth;
  EXPECT_EQ(on_distance(deep, -0.25, "graze").verdict, Verdict::Wrong);
  EXPECT_EQ(on_distance(deep, 0.25).verdict, Verdict::Wrong);
}

TEST(ShapeAnswers, WithinIsJudgedByBothBounds) {
  for (const Known& each : known_distances()) {
    SCOPED_TRACE(each.name);
    const Case query = of_bodies(Ask::Distance, each.a, each.b, {each.at_x, 0, 0});
    for (const double off : {0.125, 1e-3, 1e-7}) {
      for (const bool says : {false, true}) {
        const Judgement beyond = on_within(query, each.distance + off, says);
        EXPECT_EQ(beyond.verdict, says ? Verdict::Right : Verdict::Wrong) << off;
        const Judgement below = on_within(query, each.distance - off, says);
        EXPECT_EQ(below.verdict, says ? Verdict::Wrong : Verdict::Right) << off;
        EXPECT_NEAR(below.error, says ? off : 0, 1e-8);
        EXPECT_EQ(on_within(query, each.distance + off, true, "graze").verdict, Verdict::Right);
        EXPECT_EQ(on_within(query, each.distance - off, false, "graze").verdict, Verdict::Right);
      }
    }
    // So near to the distance neither bound decides, but of what is exact; graze's own is right.
    const CaseAnswer own = answer_case([&] {
      Case within = query;
      within.ask = Ask::Within;
      within.settings.clearance = each.distance;
      return within;
    }());
    EXPECT_NE(on_within(query, each.distance, *own.says, "graze").verdict, Verdict::Wrong);
  }
  const Case deep = of_bodies(Ask::Distance, Box{{1, 1, 1}}, Cone{1, 1}, {0.5, 0, 0});
  EXPECT_EQ(on_within(deep, 0, true).verdict, Verdict::Right) << "they meet";
  EXPECT_EQ(on_within(deep, 1, false).verdict, Verdict::Wrong);
}

/// Two boxes 0.25 m deep along x; B is on the side of +x.
class OthersContacts : public testing::Test {
 protected:
  static CaseShapeContact contact(double y, double depth, std::uint32_t number) {
    return {{0.875, y, 0}, std::nullopt, std::nullopt, {1, 0, 0}, depth, {number, number}};
  }
  Judgement on(std::vector<CaseShapeContact> contacts) const {
    CaseAnswer answer;
    answer.manifold = std::move(contacts);
    return Judge(query_).judge(answer, {"other", ""});
  }
  Case query_ = of_bodies(Ask::Contacts, Box{{1, 1, 1}}, Box{{1, 0.5, 0.5}}, {1.75, 0, 0});
};

TEST_F(OthersContacts, InAnyNumberAndOrderAreRight) {
  EXPECT_EQ(on({contact(0, 0.25, 0)}).verdict, Verdict::Right) << on({contact(0, 0.25, 0)}).truth;
  std::vector<CaseShapeContact> many;
  for (std::uint32_t i = 0; i < 8; ++i)
    many.push_back(contact(0.05 * i, i == 5 ? 0.25 : 0.125, i));
  EXPECT_EQ(on(many).verdict, Verdict::Right) << on(many).truth;
  many[2].depth = 0.25 + 1e-7;
  EXPECT_EQ(on(many).verdict, Verdict::Right) << "others are granted float";
}

/// Out along a diagonal of a corner B is free of A before a plane across the diagonal parts them;
/// along x it is free sooner.
TEST_F(OthersContacts, ADepthThatFreesBBesideIsAWayOutButNotTheLeast) {
  const Case corner = of_bodies(Ask::Contacts, Box{{1, 1, 1}}, Box{{1, 1, 1}}, {1.75, 1.5, 0});
  const auto on_diagonal = [&](double depth) {
    CaseAnswer answer;
    answer.manifold = {
        {{0.875, 0.75, 0}, std::nullopt, std::nullopt, {0.6, 0.8, 0}, depth, {0, 0}}};
    return Judge(corner).judge(answer, {"other", ""});
  };
  // Free once x has gone 0.25: after 0.25 / 0.6; a plane across needs 0.6 * 0.25 + 0.8 * 0.5.
  for (const double depth : {0.25 / 0.6 + 1e-6, 0.5, 0.55}) {
    const Judgement judgement = on_diagonal(depth);
    EXPECT_EQ(judgement.verdict, Verdict::Wrong);
    EXPECT_EQ(judgement.error_class, ErrorClass::NotLeast) << judgement.truth;
    EXPECT_NEAR(judgement.error, depth - 0.25, 1e-9);
  }
  for (const double depth : {0.25 / 0.6 - 0.05, 0.56}) {
    EXPECT_EQ(on_diagonal(depth).verdict, Verdict::Wrong);
    EXPECT_EQ(on_diagonal(depth).error_class, ErrorClass::Real);
  }
  const std::string truth = on_diagonal(0.5).truth;
  EXPECT_NE(truth.find("a way out of 0.5 m, not the least: a plane parts them after 0.25 m, and "
                       "none before 0.25 m"),
            std::string::npos)
      << truth;
}

TEST_F(OthersContacts, PlantedFaultsAreFound) {
  CaseShapeContact reversed = contact(0, 0.25, 0);
  reversed.normal = {-1, 0, 0};
  CaseShapeContact longer = contact(0, 0.25, 0);
  longer.normal *= 2;
  CaseShapeContact aside = contact(0, 0.25, 0);
  aside.point.y() = 3;
  CaseShapeContact oblique = contact(0, 0.25, 0);
  oblique.normal = {0.6, 0.8, 0};
  for (const CaseShapeContact& each : {reversed, longer, aside, oblique, contact(0, 0.5, 0),
                                       contact(0, 0.125, 0), contact(0, -0.25, 0)}) {
    const Judgement judgement = on({each});
    EXPECT_EQ(judgement.verdict, Verdict::Wrong) << each.normal.transpose() << ' ' << each.depth;
    EXPECT_EQ(judgement.error_class, ErrorClass::Real);
  }
  const std::string truth = on({contact(0, 0.125, 0)}).truth;
  EXPECT_NE(truth.find("which is 0.125 m: a plane across the normal parts them after 0.25 m"),
            std::string::npos)
      << truth;
  EXPECT_EQ(on({}).verdict, Verdict::Wrong) << "they meet";
}

/// Two boxes 0.25 m deep along x, and 1.5 m along y; B is on the side of +x.
class Separations : public testing::Test {
 protected:
  Judgement on(const Eigen::Vector3d& translation, const char* engine = "other") const {
    return on(translation, translation.norm(), engine);
  }
  Judgement on(const Eigen::Vector3d& translation, double length, const char* engine) const {
    CaseAnswer answer;
    answer.distance = length;
    answer.translation = translation;
    return Judge(query_).judge(answer, {engine, ""});
  }
  Case query_ = of_bodies(Ask::Separation, Box{{1, 1, 1}}, Box{{1, 0.5, 0.5}}, {1.75, 0, 0});
};

TEST_F(Separations, ThatPartTheTwoAndAreTheShortestAreRight) {
  const Judgement least = on({0.25, 0, 0});
  EXPECT_EQ(least.verdict, Verdict::Right) << least.truth;
  EXPECT_EQ(least.truth,
            "hit, apart after it; a plane parts them after 0.25 m, and none before 0.25 m");
  EXPECT_EQ(on({0.25 + 1e-6, 0, 0}).verdict, Verdict::Right) << "others are granted float";
  EXPECT_EQ(Judge(query_).judge(answer_case(query_), this_library()).verdict, Verdict::Right);
}

TEST_F(Separations, PlantedFaultsAreFound) {
  for (const Eigen::Vector3d& wrong :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.125, 0, 0), Eigen::Vector3d(0.25 + 1e-4, 0, 0),
        Eigen::Vector3d(-0.25, 0, 0), Eigen::Vector3d(0.15, 0.2, 0)}) {
    const Judgement judgement = on(wrong);
    EXPECT_EQ(judgement.verdict, Verdict::Wrong) << wrong.transpose() << ": " << judgement.truth;
    EXPECT_EQ(judgement.error_class, ErrorClass::Real);
  }
  EXPECT_NEAR(on({0.125, 0, 0}).error, 0.125, 1e-6) << "as far as it still has to go";
  EXPECT_NEAR(on({0.5, 0, 0}).error, 0.25, 1e-12);
  const Judgement other_way = on({0, 1.5, 0});
  EXPECT_EQ(other_way.verdict, Verdict::Wrong) << "it parts them, but another is shorter";
  EXPECT_NEAR(other_way.error, 1.25, 1e-12);
  EXPECT_EQ(other_way.error_class, ErrorClass::NotLeast);
  EXPECT_NE(
      other_way.truth.find("a way out of 1.5 m, not the least: a plane parts them after 0.25 m"),
      std::string::npos)
      << other_way.truth;
  EXPECT_EQ(on({0.25, 0, 0}, 0.5, "other").verdict, Verdict::Wrong) << "of another length";
  EXPECT_EQ(on({0.25, 0, 0}, 0.25 + 1e-7, "graze").verdict, Verdict::Wrong);
  query_ = of_bodies(Ask::Separation, Box{{1, 1, 1}}, Box{{1, 0.5, 0.5}}, {2.25, 0, 0});
  EXPECT_EQ(on({0, 0, 0}).verdict, Verdict::Right) << "they are apart";
  EXPECT_EQ(on({0.125, 0, 0}).verdict, Verdict::Wrong) << "there is nothing to undo";
}

/// A surface may be left to the inside, too, so that a shorter way may be there: the bound is
/// named.
TEST_F(Separations, OfSurfacesMustPartThemAndBeNoLongerThanOfTheirHulls) {
  query_ = of_bodies(Ask::Separation, tests::make_box({1, 1, 1}), Box{{1, 1, 1}}, {1.75, 0, 0});
  const Judgement out = on({0.25, 0, 0});
  EXPECT_EQ(out.verdict, Verdict::NotJudged);
  EXPECT_EQ(out.truth,
            "hit, apart after it; a plane parts them after 0.25 m; not judged: whether a shorter "
            "one does");
  EXPECT_EQ(on({0.125, 0, 0}).verdict, Verdict::Wrong) << "still a hit";
  EXPECT_EQ(on({0.5, 0, 0}).verdict, Verdict::Wrong) << "a plane parts them sooner";
  query_ = of_bodies(Ask::Separation, tests::make_box({1, 1, 1}), tests::make_box({1, 1, 1}),
                     {1.75, 0, 0});
  EXPECT_EQ(on({0.25, 0, 0}).verdict, Verdict::NotJudged);
  EXPECT_EQ(on({0.125, 0, 0}).verdict, Verdict::Wrong);
  EXPECT_EQ(on({0.5, 0, 0}).verdict, Verdict::Wrong);
  EXPECT_EQ(on({0, 0, 0}).verdict, Verdict::Wrong);
}

TEST_F(Separations, OfAPlaneAreTheShorterOfItsTwoSides) {
  query_ = of_bodies(Ask::Separation, Plane{{1, 0, 0}, 1}, Box{{1, 1, 1}}, {1.75, 0, 0});
  EXPECT_EQ(on({0.25, 0, 0}).verdict, Verdict::Right) << on({0.25, 0, 0}).truth;
  EXPECT_EQ(on({-1.75, 0, 0}).verdict, Verdict::Wrong) << "the longer way";
  EXPECT_EQ(on({0.125, 0, 0}).verdict, Verdict::Wrong) << on({0.125, 0, 0}).truth;
}

TEST_F(Separations, OfOtherEnginesAreTheirDeepestContacts) {
  for (const EngineEntry& entry : all_engines()) {
    if (entry.engine == nullptr) continue;
    const std::optional<CaseAnswer> answer = ask(*entry.engine, query_);
    if (!answer) continue;
    EXPECT_NEAR(*answer->distance, 0.25, 1e-6) << entry.name;
    EXPECT_NEAR(answer->translation->x(), 0.25, 1e-6) << entry.name;
    EXPECT_EQ(Judge(query_).judge(*answer, entry.engine->name()).verdict, Verdict::Right)
        << entry.name;
  }
}

/// Whatever the shapes are, graze's way out is one by a judge who uses only its proposals.
TEST(ShapeAnswers, GrazeIsRightAboutWaysOut) {
  RandomSource random(9);
  const std::vector<Shape> shapes = {Sphere{{0, 0, 0}, 0.5}, Box{{0.5, 0.25, 0.75}},
                                     Capsule{0.25, 0.5},     Cylinder{0.5, 0.25},
                                     Cone{0.5, 0.5},         Ellipsoid{{0, 0, 0}, {0.5, 1, 0.25}}};
  std::size_t ways = 0;
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d at{random.uniform(-1, 1), random.uniform(-1, 1),
                                 random.uniform(-1, 1)};
        const Case query = of_bodies(Ask::Separation, a, b, at);
        const CaseAnswer answer = answer_case(query);
        const Judgement judgement = Judge(query).judge(answer, this_library());
        EXPECT_NE(judgement.verdict, Verdict::Wrong) << judgement.truth;
        ways += judgement.verdict == Verdict::Right && *answer.distance > 0;
      }
    }
  }
  EXPECT_GT(ways, 36u);
}

/// What graze says of shapes at random is never wrong by the judge who uses only its proposals.
TEST(ShapeAnswers, GrazeIsRightAboutWhatIsWithin) {
  RandomSource random(7);
  const std::vector<Shape> shapes = {Sphere{{0, 0, 0}, 0.5},  Box{{0.5, 0.25, 0.75}},
                                     Capsule{0.25, 0.5},      Cylinder{0.5, 0.25},
                                     Cone{0.5, 0.5},          Ellipsoid{{0, 0, 0}, {0.5, 1, 0.25}},
                                     HalfSpace{{0, 0, 1}, -1}};
  std::size_t judged = 0;
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      if (a.kind() == ShapeKind::HalfSpace && b.kind() == ShapeKind::HalfSpace) continue;
      for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d at{random.uniform(-2, 2), random.uniform(-2, 2),
                                 random.uniform(-1, 2)};
        Case query = of_bodies(Ask::Within, a, b, at, random.uniform(0, 1));
        const Judgement judgement = Judge(query).judge(answer_case(query), this_library());
        EXPECT_NE(judgement.verdict, Verdict::Wrong) << judgement.truth;
        judged += judgement.verdict == Verdict::Right;
      }
    }
  }
  EXPECT_GT(judged, 48u * 8 - 8);
}

}  // namespace
}  // namespace graze::compare

// Whether the depth of a contact of two convex shapes is the least of all directions: depths known
// by hand, planted errors beside them, and graze's own answers, in positions at random and in those
// where many directions are as good.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_source.h"

namespace graze::compare {
namespace {

using Eigen::Vector3d;

const double kRoot5 = std::sqrt(5.0);

Pose placed(const Vector3d& at, const Vector3d& turned_about = Vector3d::UnitX(),
            double angle = 0) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(angle, turned_about).toRotationMatrix();
  pose.translation() = at;
  return pose;
}

Case contacts_of(const Shape& a, const Shape& b, const Pose& pose_b) {
  return {.note = "",
          .ask = Ask::Contacts,
          .settings = {},
          .a = CaseBody(a, Pose::Identity()),
          .b = CaseBody(b, pose_b),
          .answer = std::nullopt,
          .answered_by = {}};
}

/// A way out, and a longer one.
struct KnownDepth {
  const char* name;
  Shape a;
  Shape b;
  Pose pose_b;
  Vector3d point;  // inside of both
  Vector3d normal;
  double depth;
  Vector3d longer_normal;
  double longer;
};

ConvexHull octahedron() {
  const std::vector<Vector3d> corners = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                         {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  return ConvexHull(corners);
}

std::vector<KnownDepth> known_depths() {
  const Vector3d here(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const double quarter = std::acos(0.0);
  return {
      // A cone's side is left sooner than its height or its base are.
      {"cone and cylinder, concentric", Cone{1, 1}, Cylinder{0.5, 1}, placed(here), here,
       Vector3d(2, 0, 1) / kRoot5, 3 / kRoot5, z, 2},
      {"cylinder in cone, upside down", Cone{1, 1}, Cylinder{0.5, 1}, placed(here, x, 2 * quarter),
       here, Vector3d(0, 2, 1) / kRoot5, 3 / kRoot5, x, 1.5},
      {"cylinders on one axis", Cylinder{1, 1}, Cylinder{0.5, 1}, placed({0, 0, 1.75}),
       Vector3d(0, 0, 0.875), z, 0.25, x, 1.5},
      {"capsules across each other", Capsule{0.25, 1}, Capsule{0.25, 1}, placed(here, y, quarter),
       here, y, 0.5, z, 1.5},
      {"boxes, concentric", Box{{1, 1, 1}}, Box{{0.5, 0.75, 0.5}}, placed(here), here, x, 1.5, y,
       1.75},
      {"boxes, aligned", Box{{1, 1, 1}}, Box{{1, 0.5, 0.5}}, placed({1.75, 0, 0}),
       Vector3d(0.875, 0, 0), x, 0.25, y, 1.5},
      {"ball in the middle of a box", Box{{1, 2, 3}}, Sphere{{0, 0, 0}, 0.5}, placed(here), here, x,
       1.5, y, 2.5},
      {"ball in the middle of an octahedron", octahedron(), Sphere{{0, 0, 0}, 0.5}, placed(here),
       here, Vector3d(1, 1, 1).normalized(), 0.5 + 1 / std::sqrt(3.0), x, 1.5},
      {"ellipsoid and ball, concentric", Ellipsoid{{0, 0, 0}, {1, 1, 0.5}}, Sphere{{0, 0, 0}, 0.25},
       placed(here), here, z, 0.75, x, 1.25},
      {"balls, concentric, as ellipsoids", Ellipsoid{{0, 0, 0}, {1, 1, 1}},
       Ellipsoid{{0, 0, 0}, {0.5, 0.5, 0.25}}, placed(here), here, z, 1.25, x, 1.5},
      {"cylinder lying on a plane of two sides", Plane{{0, 0, 1}, 0}, Cylinder{0.5, 1},
       placed({0, 0, 0.25}, x, quarter), Vector3d(0, 0, 0), z, 0.25, -z, 0.75},
  };
}

CaseAnswer planted(const Vector3d& point, const Vector3d& normal, double depth) {
  CaseAnswer answer;
  answer.manifold = {{point, std::nullopt, std::nullopt, normal, depth, {0, 0}}};
  return answer;
}

bool has(const Judgement& judgement, const std::string& words) {
  return judgement.truth.find(words) != std::string::npos;
}

TEST(ContactDepth, ThatIsTheLeastIsRightAndBothBoundsAreStated) {
  for (const KnownDepth& each : known_depths()) {
    SCOPED_TRACE(each.name);
    const Case query = contacts_of(each.a, each.b, each.pose_b);
    const Judge judge(query);
    for (const double off : {0.0, 1e-6, -1e-6}) {  // in single precision that is the same
      const double depth = each.depth * (1 + off);
      const Judgement judgement =
          judge.judge(planted(each.point, each.normal, depth), {"other", ""});
      EXPECT_EQ(judgement.verdict, Verdict::Right) << judgement.truth;
      EXPECT_TRUE(has(judgement, "a plane parts them after")) << judgement.truth;
      EXPECT_TRUE(has(judgement, "and none before")) << judgement.truth;
    }
  }
}

TEST(ContactDepth, ThatIsNoWayOutOrLongerThanItsOwnIsAPlainError) {
  for (const KnownDepth& each : known_depths()) {
    SCOPED_TRACE(each.name);
    const Case query = contacts_of(each.a, each.b, each.pose_b);
    const Judge judge(query);
    for (const double off : {1e-3, -1e-3, 0.5, -0.5}) {
      const double depth = each.depth * (1 + off);
      const Judgement judgement =
          judge.judge(planted(each.point, each.normal, depth), {"other", ""});
      EXPECT_EQ(judgement.verdict, Verdict::Wrong) << off << ' ' << judgement.truth;
      EXPECT_EQ(judgement.error_class, ErrorClass::Real) << off << ' ' << judgement.truth;
      EXPECT_EQ(off < 0, has(judgement, "and none before")) << judgement.truth;
    }
  }
}

TEST(ContactDepth, ThatIsAWayOutButNotTheLeastHasItsOwnClass) {
  for (const KnownDepth& each : known_depths()) {
    SCOPED_TRACE(each.name);
    const Case query = contacts_of(each.a, each.b, each.pose_b);
    const Judgement judgement =
        Judge(query).judge(planted(each.point, each.longer_normal, each.longer), {"other", ""});
    EXPECT_EQ(judgement.verdict, Verdict::Wrong) << judgement.truth;
    EXPECT_EQ(judgement.error_class, ErrorClass::NotLeast) << judgement.truth;
    EXPECT_NEAR(judgement.error, each.longer - each.depth, 1e-5);
    EXPECT_TRUE(has(judgement, ", not the least: a plane parts them after")) << judgement.truth;
    EXPECT_TRUE(has(judgement, "and none before")) << judgement.truth;
  }
}

/// As near to the least as a hundred thousandth of the size is as good; a little more is told.
TEST(ContactDepth, IsToldFromTheLeastByMoreThanTheToleranceAlone) {
  const double quarter = std::acos(0.0);
  const Case query = contacts_of(Capsule{0.25, 1}, Capsule{0.25, 1},
                                 placed({0, 0, 0}, Vector3d::UnitY(), quarter));
  const Judge judge(query);
  for (const double aside : {1e-5, 1e-4}) {  // the way out gets as much longer
    const Vector3d normal = Vector3d(0, 1, aside).normalized();
    const Judgement judgement =
        judge.judge(planted({0, 0, 0}, normal, 0.5 + normal.z()), {"other", ""});
    EXPECT_EQ(judgement.verdict, aside < 2e-5 ? Verdict::Right : Verdict::Wrong) << judgement.truth;
    EXPECT_EQ(aside > 2e-5, has(judgement, "not the least")) << judgement.truth;
  }
}

TEST(ContactDepth, ReversedNormalsAreSaidToBeSuch) {
  const Case query = contacts_of(Cone{1, 1}, Cylinder{0.5, 1}, placed({0, 0, -1.75}));
  const Judge judge(query);
  const auto on = [&](const Vector3d& normal) {
    return judge.judge(planted({0, 0, -0.875}, normal, 0.25), {"other", ""});
  };
  EXPECT_EQ(on({0, 0, -1}).verdict, Verdict::Right) << on({0, 0, -1}).truth;
  EXPECT_EQ(on({0, 0, 1}).verdict, Verdict::Wrong);
  EXPECT_TRUE(has(on({0, 0, 1}), "a normal from B to A")) << on({0, 0, 1}).truth;
}

TEST(ContactDepth, OfSurfacesIsNotJudged) {
  const Case query =
      contacts_of(tests::make_box({1, 1, 1}), Box{{1, 0.5, 0.5}}, placed({1.75, 0, 0}));
  for (const Vector3d& normal : {Vector3d(1, 0, 0), Vector3d(0, 1, 0)}) {
    const Judgement judgement = Judge(query).judge(
        planted({1, 0.5, 0}, normal, normal.x() > 0 ? 0.25 : 1.5), {"other", ""});
    EXPECT_EQ(judgement.verdict, Verdict::NotJudged) << judgement.truth;
    EXPECT_TRUE(has(judgement, "normals and depths")) << judgement.truth;
  }
}

/// Other engines tell a depth as a distance below zero, too. What they mean by it is theirs.
TEST(ContactDepth, ThatIsToldAsADistanceIsRightIfItIsTheLeast) {
  for (const KnownDepth& each : known_depths()) {
    SCOPED_TRACE(each.name);
    Case query = contacts_of(each.a, each.b, each.pose_b);
    query.ask = Ask::Distance;
    const Judge judge(query);
    const auto on = [&](double distance) {
      CaseAnswer answer;
      answer.distance = distance;
      return judge.judge(answer, {"other", ""});
    };
    EXPECT_EQ(on(-each.depth).verdict, Verdict::Right) << on(-each.depth).truth;
    for (const double off : {1.01, 0.99}) {
      EXPECT_EQ(on(-off * each.depth).verdict, Verdict::NotJudged);
      EXPECT_TRUE(has(on(-off * each.depth), "how deep: a plane parts them after"));
    }
    EXPECT_EQ(on(each.depth).verdict, Verdict::Wrong);
  }
}

/// graze promises the least, so that its own answers are held to it: where it gives a longer way
/// (here planted into its name), that is told, too.
TEST(ContactDepth, OfGrazeIsHeldToTheLeast) {
  for (const KnownDepth& each : known_depths()) {
    SCOPED_TRACE(each.name);
    const Case query = contacts_of(each.a, each.b, each.pose_b);
    const Judge judge(query);
    CaseAnswer own = answer_case(query);
    const Judgement right = judge.judge(own, this_library());
    EXPECT_NE(right.verdict, Verdict::Wrong) << right.truth;
    EXPECT_TRUE(has(right, "and none before")) << right.truth;
    EXPECT_NEAR((*own.manifold)[0].depth, each.depth, 1e-3);
    own.manifold = {
        {each.point, std::nullopt, std::nullopt, each.longer_normal, each.longer, {0, 0}}};
    EXPECT_EQ(judge.judge(own, this_library()).verdict, Verdict::Wrong);
  }
}

/// At random, concentric, turned by right angles, along one axis: graze is never wrong, and hardly
/// ever left open.
TEST(ContactDepth, OfGrazeIsRightForAllKindsWhereverTheyAre) {
  RandomSource random(11);
  const std::vector<Shape> shapes = {Sphere{{0, 0, 0}, 0.5},
                                     Box{{0.5, 0.25, 0.75}},
                                     Capsule{0.25, 0.5},
                                     Cylinder{0.5, 0.25},
                                     Cone{0.5, 0.5},
                                     Ellipsoid{{0, 0, 0}, {0.5, 1, 0.25}},
                                     octahedron()};
  const auto some = [&](double most) {
    return Vector3d{random.uniform(-most, most), random.uniform(-most, most),
                    random.uniform(-most, most)};
  };
  const double quarter = std::acos(0.0);
  std::size_t right = 0, all = 0;
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      std::vector<Pose> poses = {placed({0, 0, 0}), placed({0, 0, 0.5}), placed({0.25, 0, 0}),
                                 placed({0, 0, 0}, Vector3d::UnitX(), quarter),
                                 placed({0.125, 0.25, 0}, Vector3d::UnitY(), quarter)};
      for (int i = 0; i < 4; ++i)
        poses.push_back(placed(some(0.4), some(1).normalized(), random.uniform(0, 3)));
      for (const Pose& pose : poses) {
        const Case query = contacts_of(a, b, pose);
        const CaseAnswer answer = answer_case(query);
        if (answer.manifold->empty()) continue;
        const Judgement judgement = Judge(query).judge(answer, this_library());
        EXPECT_NE(judgement.verdict, Verdict::Wrong)
            << name_of(a.kind()) << ' ' << name_of(b.kind()) << ": " << judgement.truth;
        ++all;
        right += judgement.verdict == Verdict::Right;
      }
    }
  }
  EXPECT_GT(all, 400u);
  EXPECT_GT(right, all * 9 / 10);
  RecordProperty("right", std::to_string(right));
}

}  // namespace
}  // namespace graze::compare

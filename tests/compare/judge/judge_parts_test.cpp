// What answers name beside their yes or number, planted faults in it, and the class of an error,
// which is one whatever the question, and kept by shrinking.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/meshes/mesh_judges.h>
#include <graze/engine/compare/judge/rational/rational_inside.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>
#include <graze/engine/compare/run/shrink_worst.h>
#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/crossing.h>
#include <gtest/gtest.h>
#include <tests/oracle/category.h>
#include <cmath>
#include <functional>

#include "tests/compare/engine_doubles.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze::compare {
namespace {

using Eigen::Vector3d;

Pose at(const Vector3d& translation) {
  Pose pose = Pose::Identity();
  pose.translation() = translation;
  return pose;
}

Case query_of(Ask ask, const CaseShape& a, const CaseShape& b, const CaseSettings& settings = {}) {
  return {.note = "",
          .ask = ask,
          .settings = settings,
          .a = a,
          .b = b,
          .answer = std::nullopt,
          .answered_by = {}};
}

CaseMesh box(const Vector3d& half_extents, const Vector3d& translation = {0, 0, 0}) {
  return {tests::make_box(half_extents), at(translation)};
}

Case of_cubes(Ask ask) {
  return query_of(ask, box({1, 1, 1}), box({1, 1, 1}, {1.5, 0, 0}));
}

using Spoil = std::function<void(CaseAnswer&)>;

/// Faults of contacts that no engine's convention allows.
std::vector<std::pair<const char*, Spoil>> contact_faults() {
  const auto first = [](CaseAnswer& a) -> CaseContact& { return a.contacts->front(); };
  return {{"normal reversed", [=](CaseAnswer& a) { first(a).normal *= -1; }},
          {"normal twice as long", [=](CaseAnswer& a) { first(a).normal *= 2; }},
          {"point 30 m away",
           [=](CaseAnswer& a) {
             first(a).point.z() += 30;
             first(a).point_a.z() += 30;
             first(a).point_b.z() += 30;
           }},
          {"depth of -0.5", [=](CaseAnswer& a) { first(a).depth = -0.5; }},
          {"thrice", [=](CaseAnswer& a) { a.contacts->insert(a.contacts->end(), 2, first(a)); }}};
}

TEST(PlantedParts, OfContactsAreFoundWhoeverGivesThem) {
  const Case query = of_cubes(Ask::Contacts);
  const Judge judge(query);
  const CaseAnswer right = answer_case(query);
  for (const char* engine : {"graze", "somebody"}) {
    EXPECT_EQ(judge.judge(right, {engine, ""}).verdict, Verdict::Right) << engine;
    for (const auto& [what, spoil] : contact_faults()) {
      CaseAnswer spoilt = right;
      spoil(spoilt);
      const Judgement judgement = judge.judge(spoilt, {engine, ""});
      // Whoever asks each pair of triangles meets a contact more than once.
      const bool may_repeat = std::string(what) == "thrice" && std::string(engine) != "graze";
      EXPECT_EQ(judgement.verdict, may_repeat ? Verdict::NotJudged : Verdict::Wrong)
          << engine << ": " << what;
    }
  }
}

/// A needle that comes in through one side of a cube and touches the opposite one from within has
/// two ways out: on through that side, and back. Neither leads from B to A.
TEST(PlantedParts, ATouchFromWithinIsNoReversedNormal) {
  const std::vector<Vector3d> corners = {
      {1, 0.125, 0.25}, {-3, 0.5, 0}, {-3, -0.5, 0.5}, {-3, -0.5, -0.5}};
  const std::vector<TriangleIndices> triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  const Case query =
      query_of(Ask::Contacts, box({1, 1, 1}), CaseMesh{Mesh(corners, triangles), at({0, 0, 0})});
  const CaseAnswer answer = answer_case(query);
  ASSERT_EQ(answer.contacts->size(), 2u);
  EXPECT_EQ(answer.contacts->front().depth, 2);
  EXPECT_EQ(answer.contacts->back().depth, 2);
  for (const char* engine : {"graze", "somebody"}) {
    const Judgement judgement = Judge(query).judge(answer, {engine, ""});
    EXPECT_NE(judgement.verdict, Verdict::Wrong) << engine << ": " << judgement.truth;
  }
}

/// A corner that touches a vertex touches all triangles there, to an engine that rounds, and each
/// pair has its contact, although an ulp may leave all but one apart.
TEST(PlantedParts, ContactsAtAVertexMayComeOnceForEachTriangleThere) {
  const std::vector<Vector3d> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {0, -1, 0}};
  const std::vector<TriangleIndices> fan = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  const std::vector<Vector3d> tip = {{0x1p-54, 0x1p-56, 0}, {1, 1, 1}, {1, -1, 1}};
  const std::vector<TriangleIndices> one = {{0, 1, 2}};
  const Case query = query_of(Ask::Contacts, CaseMesh{Mesh(corners, fan), at({0, 0, 0})},
                              CaseMesh{Mesh(tip, one), at({0, 0, 0})});
  CaseAnswer answer = answer_case(query);
  ASSERT_EQ(answer.contacts->size(), 1u);
  const Judge judge(query);
  const auto repeated = [&](std::size_t count) {
    CaseAnswer many = answer;
    many.contacts->assign(count, answer.contacts->front());
    return judge.judge(many, {"bullet", ""}).verdict;
  };
  EXPECT_EQ(repeated(9), Verdict::NotJudged);
  EXPECT_EQ(repeated(100), Verdict::Wrong);
}

/// A wrapper of FCL has another name than FCL, and is judged as FCL is: what it repeats is no
/// error, what is planted is one.
TEST(PlantedParts, AWrapperOfAnEngineIsJudgedAsThatIs) {
  const Case query =
      query_of(Ask::Contacts, box({1, 1, 1}), box({0.5, 0.75, 1}, {1.25, 0.5, 0.125}));
  const Judge judge(query);
  for (const EngineEntry& entry : all_engines()) {
    if (entry.engine == nullptr || entry.name == "graze") continue;
    std::optional<CaseAnswer> answer = ask(*entry.engine, query);
    if (!answer) continue;
    const Judgement own = judge.judge(*answer, entry.engine->name());
    const Judgement wrapped = judge.judge(*answer, {"my-" + entry.name, ""});
    EXPECT_EQ(wrapped.verdict, own.verdict) << entry.name << ": " << wrapped.truth;
    for (CaseContact& c : *answer->contacts)
      c.normal *= 2;
    EXPECT_EQ(judge.judge(*answer, {"my-" + entry.name, ""}).verdict, Verdict::Wrong);
  }
}

/// Where two triangles cross, a pair's own normal may lead back by chance. That is no error as long
/// as others lead nowhere: only contacts that all lead back are from B to A.
TEST(PlantedParts, OneOfManyPairsMayLeadBack) {
  const Case query = of_cubes(Ask::Contacts);
  const Judge judge(query);
  CaseAnswer said = answer_case(query);
  for (CaseContact& c : *said.contacts) {
    c.normal *= -1;
    c.point_a = c.point_b = c.point;  // FCL gives one
  }
  const Judgement back = judge.judge(said, {"fcl", ""});
  EXPECT_EQ(back.verdict, Verdict::Wrong);
  EXPECT_NE(back.truth.find("a normal from B to A"), std::string::npos) << back.truth;
  CaseContact sideways = said.contacts->front();
  sideways.normal = sideways.normal.unitOrthogonal();
  said.contacts->push_back(sideways);
  const Judgement found = judge.judge(said, {"fcl", ""});
  EXPECT_EQ(found.verdict, Verdict::NotJudged) << found.truth;
}

/// Engines that give contacts for each pair of triangles are never right: their depths are not
/// judged.
TEST(PlantedParts, WhatIsNotJudgedIsNeverRight) {
  const Case query = of_cubes(Ask::Contacts);
  const Judge judge(query);
  for (const EngineEntry& entry : all_engines()) {
    if (entry.engine == nullptr || entry.name == "graze") continue;
    const std::optional<CaseAnswer> answer = ask(*entry.engine, query);
    if (!answer) continue;
    EXPECT_EQ(judge.judge(*answer, entry.engine->name()).verdict, Verdict::NotJudged) << entry.name;
    CaseAnswer reversed = answer_case(query);
    for (CaseContact& c : *reversed.contacts)
      c.normal *= -1;
    EXPECT_EQ(judge.judge(reversed, entry.engine->name()).verdict, Verdict::Wrong) << entry.name;
  }
  const Case torus =
      query_of(Ask::Contacts, CaseMesh(tests::make_torus(1, 0.3, 12, 8), at({0, 0, 0})),
               box({0.25, 0.25, 0.25}, {1, 0.125, 0.25}));
  const Judgement of_torus = Judge(torus).judge(answer_case(torus), this_library());
  EXPECT_EQ(of_torus.verdict, Verdict::NotJudged);
  EXPECT_NE(of_torus.truth.find("not judged: normals"), std::string::npos) << of_torus.truth;
}

TEST(PlantedParts, AWrongPairOrLengthIsFound) {
  Case query = query_of(Ask::Distance, box({1, 1, 1}), box({1, 1, 1}, {3, 0.25, 0}));
  CaseAnswer answer = answer_case(query);
  EXPECT_EQ(Judge(query).judge(answer, this_library()).verdict, Verdict::Right);
  answer.point_a.reset();
  answer.pair->a = 0;  // on the far side
  const Judgement pair = Judge(query).judge(answer, {"somebody", ""});
  EXPECT_EQ(pair.verdict, Verdict::Wrong);
  EXPECT_EQ(pair.error, 2);
  query = of_cubes(Ask::Separation);
  answer = answer_case(query);
  EXPECT_EQ(Judge(query).judge(answer, this_library()).verdict, Verdict::Right);
  *answer.distance *= 2;
  const Judgement length = Judge(query).judge(answer, this_library());
  EXPECT_EQ(length.verdict, Verdict::Wrong);
  EXPECT_NEAR(length.error, 0.5, 1e-12);
}

TEST(JudgeParts, CrossingsAreThoseOfTheLibraryInAllHardCases) {
  std::size_t crossings = 0;
  for (const auto& corpus : oracle::pair_corpora()) {
    for (std::uint64_t i = 0; i < 6; ++i) {
      const oracle::TrianglePair pair = corpus.element(i * 53);
      const bool do_they = do_cross(exactly(pair.a), exactly(pair.b));
      ASSERT_EQ(do_they, crosses(pair.a, pair.b)) << corpus.name() << " element " << i * 53;
      crossings += do_they;
    }
  }
  EXPECT_GT(crossings, 50u);
}

/// Points on vertices, edges and faces' planes included, which rays along x meet.
TEST(JudgeParts, PointsAreInsideByTheRuleOfHalfOpenEdges) {
  for (const Mesh& mesh : {tests::make_box({1, 1, 1}), tests::make_torus(1, 0.375, 8, 6)}) {
    std::vector<Triangle> surface;
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i)
      surface.push_back(mesh.triangle(i));
    std::vector<Vector3d> points(mesh.vertices().begin(), mesh.vertices().end());
    for (int x = -5; x <= 5; ++x) {
      for (int y = -5; y <= 5; ++y)
        points.emplace_back(x / 4.0, y / 4.0, (x + y) % 3 / 4.0);
    }
    for (const Vector3d& vertex : mesh.vertices())
      points.emplace_back(vertex.x() / 2, vertex.y(), vertex.z());
    std::size_t inside = 0;
    for (const Vector3d& p : points) {
      const bool is_in = is_on_surface(surface, p) || is_enclosed(surface, p);
      ASSERT_EQ(is_in, contains(mesh, p)) << p.transpose();
      inside += is_in;
    }
    EXPECT_GT(inside, mesh.vertices().size());
    EXPECT_LT(inside, points.size());
  }
}

/// A small cube in a corner of a larger one, 2^-53 m from its wall.
Case nearly_touching(Ask ask) {
  Case query = query_of(ask, box({1, 1, 1}),
                        box({0.125, 0.125, 0.125}, {1 - 0.125 - 0x1p-53, 0.0625, 0.03125}),
                        {.clearance = 0});
  return query;
}

TEST(JudgeClasses, AGapOfRoundingHasOneClassWhateverTheQuestion) {
  const auto class_of = [](Ask ask, const Spoil& claim) {
    const Case query = nearly_touching(ask);
    CaseAnswer answer;
    claim(answer);
    const Judgement judgement = Judge(query).judge(answer, {"graze", ""});
    EXPECT_EQ(judgement.verdict, Verdict::Wrong) << name_of(ask);
    EXPECT_EQ(judgement.error, 0x1p-53) << name_of(ask);
    return judgement.error_class;
  };
  const Case query = nearly_touching(Ask::Any);
  EXPECT_FALSE(*answer_case(query).says);
  const TrianglePair nearest = *answer_case(nearly_touching(Ask::Distance)).pair;
  EXPECT_EQ(class_of(Ask::Any, [](CaseAnswer& a) { a.says = true; }), ErrorClass::Touching);
  EXPECT_EQ(class_of(Ask::Pairs, [&](CaseAnswer& a) { a.pairs = {nearest}; }),
            ErrorClass::Touching);
  EXPECT_EQ(class_of(Ask::Distance, [](CaseAnswer& a) { a.distance = 0; }), ErrorClass::Touching);
  EXPECT_EQ(class_of(Ask::Contacts, [](CaseAnswer& a) { a.contacts.emplace(1); }),
            ErrorClass::Touching);
}

TEST(JudgeClasses, CoplanarTrianglesAreAClass) {
  const Triangle flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Triangle other{{1, 1, 0}, {5, 1, 0}, {1, 5, 0}};
  const auto class_of = [&](const Triangle& t, bool says) {
    CaseAnswer answer;
    answer.says = says;
    return Judge(query_of(Ask::Any, flat, t)).judge(answer, {"somebody", ""}).error_class;
  };
  EXPECT_EQ(class_of(other, false), ErrorClass::Coplanar);
  const Triangle beside{{4 + 0x1p-50, 0, 0}, {5, 0, 0}, {5, 1, 0}};
  EXPECT_EQ(class_of(beside, true), ErrorClass::Coplanar);
  const Triangle far{{5, 0, 0}, {6, 0, 0}, {6, 1, 0}};
  EXPECT_EQ(class_of(far, true), ErrorClass::Real) << "no rounding takes it for a hit";
  EXPECT_EQ(class_of({{1, 1, 0}, {1, 2, 0}, {1, 3, 0}}, false), ErrorClass::Degenerate);
  EXPECT_EQ(class_of({{1, 1, 0}, {1, 2, 1}, {2, 1, 1}}, false), ErrorClass::Touching);
}

/// An engine that takes all that is nearer than a bound for a hit.
class Thick : public Engine {
  class Pair : public LoadedPair {
   public:
    Pair(const Mesh& mesh_a, const Mesh& mesh_b) : mesh_a_(mesh_a), mesh_b_(mesh_b) {}
    std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                     const Pose& pose_b) const override {
      if (question.ask != Ask::Any) return std::nullopt;
      CaseAnswer answer;
      answer.says = distance({mesh_a_, pose_a}, {mesh_b_, pose_b}).distance <= 1e-12;
      return answer;
    }

   private:
    Mesh mesh_a_;
    Mesh mesh_b_;
  };

 public:
  CaseWitness name() const override { return {"thick", "planted"}; }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<Pair>(mesh_a, mesh_b);
  }
};

TEST(Shrinking, KeepsTheClassAndLetsNoErrorGrow) {
  std::vector<EngineEntry> engines;
  engines.push_back({"thick", std::make_unique<Thick>()});
  RandomSource source(5);
  std::size_t seen = 0;
  const Mesh ball = tests::make_sphere(0.5, 5, 7);
  for (int run = 0; run < 12; ++run) {
    Pose pose = tests::random_pose(0, source);
    // As near as can be without a touch, by halving.
    const Vector3d way = source.vector(-1, 1).normalized();
    double hit = 0;
    double miss = 4;
    for (int i = 0; i < 200; ++i) {
      const double middle = hit / 2 + miss / 2;
      pose.translation() = middle * way;
      (intersects({ball}, {ball, pose}) ? hit : miss) = middle;
    }
    pose.translation() = miss * way;
    const Case query = query_of(Ask::Any, CaseMesh(ball, Pose::Identity()), CaseMesh(ball, pose));
    AnswerRecord record;
    record.engine = "thick";
    record.judgement = Judge(query).judge(*ask(*engines[0].engine, query), {"thick", ""});
    if (record.judgement.verdict != Verdict::Wrong) continue;
    ++seen;
    WrongAnswer wrong;
    wrong.answer = std::make_shared<const AnswerRecord>(record);
    wrong.query = [&] { return query; };
    const std::vector<WrongAnswer> all = {wrong};
    std::vector<ShrunkCase> shrunk;
    shrink_worst(all, engines,
                 {.on_done = [&](ShrunkCase each) { shrunk.push_back(std::move(each)); }});
    ASSERT_EQ(shrunk.size(), 1u);
    EXPECT_EQ(name_of(shrunk[0].judgement.error_class), name_of(record.judgement.error_class));
    EXPECT_LE(shrunk[0].judgement.error, record.judgement.error);
  }
  EXPECT_GT(seen, 3u);
}

}  // namespace
}  // namespace graze::compare

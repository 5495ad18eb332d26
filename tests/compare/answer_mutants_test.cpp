// Right answers, spoilt on purpose: none of them may be called right. And what graze answers is
// never called wrong.

#include <graze/bvh/error.h>
#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <gtest/gtest.h>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "tests/compare/answer_mutants.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze::compare {
namespace {

using Eigen::Vector3d;

Case asking(Ask ask, const CaseShape& a, const CaseShape& b, const CaseSettings& settings = {}) {
  return {.note = "",
          .ask = ask,
          .settings = settings,
          .a = a,
          .b = b,
          .answer = std::nullopt,
          .answered_by = {}};
}

/// Metres. What a search may be off by of bodies of about a metre.
constexpr double kDepthTolerance = 1e-6;

/// What may be called right though it was spoilt, for it may be right too: then the judge has
/// proved it as it proves any answer.
bool may_be_right(const Case& query, const CaseAnswer& answer, const std::string& what) {
  const auto begins = [&](const char* with) { return what.rfind(with, 0) == 0; };
  switch (query.ask) {
    case Ask::Contacts:  // a point on faces that meet, any of a set, a normal where corners meet
      if (begins("manifold: depths")) return answer.manifold->front().depth < kDepthTolerance;
      return begins("manifold: point moved by 0.0") || begins("manifold: the first left out") ||
             begins("manifold: normal turned") || begins("manifold: points swapped") ||
             begins("contacts: the first left out");
    case Ask::Distance:  // several pairs are as near
      return begins("pair: ");
    case Ask::Ray:  // at a corner, or an edge
      return begins("hits: normal turned") || begins("hits: another triangle");
    case Ask::Separation:  // the other way out of what is alike on both sides
      return begins("translation: negated") && !query.settings.direction;
    default:
      return false;
  }
}

std::string kind_of(const CaseShape& shape) {
  const auto* body = std::get_if<CaseBody>(&shape);
  return std::string(name_of(shape)) +
         (body == nullptr ? "" : std::string(" ") + name_of(body->shape.kind()));
}

/// How often what was said, by question and what was done to the answer.
class Tally {
 public:
  void judge(const Case& query, RandomSource& source) {
    std::optional<CaseAnswer> answer;
    try {
      answer = answer_case(query);
    } catch (const Error&) {
      return;  // graze refuses the question
    }
    const Judge judge(query);
    const Judgement judgement = judge.judge(*answer, this_library());
    const std::string question =
        std::string(name_of(query.ask)) + " of " + kind_of(query.a) + " and " + kind_of(*query.b);
    ++counts_[question + ", as it is"][judgement.verdict];
    EXPECT_NE(judgement.verdict, Verdict::Wrong) << question << ": " << judgement.truth << "\n"
                                                 << to_json(query);
    for (const AnswerMutant& mutant : mutants_of(*answer, source)) {
      const Judgement spoilt = judge.judge(mutant.answer, this_library());
      ++counts_[question + ", " + mutant.what][spoilt.verdict];
      ++all_;
      wrong_ += spoilt.verdict == Verdict::Wrong;
      if (spoilt.verdict != Verdict::Right || may_be_right(query, *answer, mutant.what)) continue;
      ADD_FAILURE() << question << ", " << mutant.what << ": " << spoilt.truth << "\n"
                    << to_json(query);
    }
  }

  std::string text() const {
    std::string text;
    for (const auto& [what, verdicts] : counts_) {
      text += what + ":";
      for (const auto& [verdict, count] : verdicts)
        text += std::string(" ") + std::to_string(count) + " " + name_of(verdict);
      text += "\n";
    }
    return text;
  }

  std::size_t all() const { return all_; }
  std::size_t wrong() const { return wrong_; }

 private:
  std::map<std::string, std::map<Verdict, std::size_t>> counts_;
  std::size_t all_ = 0;
  std::size_t wrong_ = 0;
};

constexpr std::array kMeshQuestions = {Ask::Any,       Ask::Pairs,    Ask::Distance,
                                       Ask::Within,    Ask::Contacts, Ask::Intersection,
                                       Ask::Separation};

void judge_meshes(Tally& tally, RandomSource& source, const Mesh& mesh_a, const Mesh& mesh_b,
                  const Pose& pose) {
  const CaseMesh a(mesh_a, Pose::Identity());
  const CaseMesh b(mesh_b, pose);
  for (const Ask ask : kMeshQuestions)
    tally.judge(asking(ask, a, b, {.clearance = ask == Ask::Within ? 0.125 : 0}), source);
  tally.judge(asking(Ask::Any, a, b, {.hit = Hit::Crossing}), source);
  tally.judge(asking(Ask::Pairs, a, b, {.hit = Hit::Crossing}), source);
  tally.judge(asking(Ask::Pairs, a, b, {.limit = 3}), source);
  tally.judge(asking(Ask::Any, a, b, {.hit = Hit::Solid}), source);
  tally.judge(asking(Ask::Separation, a, b, {.direction = Vector3d(1, 2, 3)}), source);
}

void judge_rays_and_points(Tally& tally, RandomSource& source, const Mesh& mesh, const Pose& pose) {
  const CaseMesh a(mesh, pose);
  const Ray ray{source.vector(-2, 2), source.vector(-1, 1)};
  const Ray along{source.lattice_point(-2, 2), Vector3d(0, 0, 1)};
  for (const Ray& each : {ray, along}) {
    tally.judge(asking(Ask::Ray, a, each), source);
    tally.judge(asking(Ask::RayAll, a, each), source);
  }
  for (const Vector3d& p : {source.vector(-1, 1), source.lattice_point(-1, 1)})
    tally.judge(asking(Ask::Contains, a, CasePoint{p}), source);
  const Aabb box{Vector3d::Constant(-0.125), Vector3d::Constant(0.125)};
  for (const CaseShape& volume : {CaseShape(box), CaseShape(Obb{pose, {0.25, 0.5, 0.125}}),
                                  CaseShape(Sphere{ray.origin, 0.5})}) {
    tally.judge(asking(Ask::Any, a, volume), source);
    tally.judge(asking(Ask::Any, a, volume, {.hit = Hit::Solid}), source);
    tally.judge(asking(Ask::Pairs, a, volume), source);
    tally.judge(asking(Ask::Pairs, a, volume, {.limit = 1}), source);
    tally.judge(asking(Ask::Contains, volume, CasePoint{source.vector(-0.5, 0.5)}), source);
  }
}

std::vector<Shape> shapes_of_all_kinds() {
  const std::vector<Vector3d> corners = {
      {0, 0, 0}, {1.5, 0, 0}, {1.5, 1, 0}, {0, 1.25, 0}, {0.25, 0.25, 1.75}};
  return {Sphere{{0.5, 0, 0.25}, 0.75},
          Box{{1, 0.75, 0.5}},
          Capsule{0.5, 0.5},
          Cylinder{0.75, 1},
          Cone{1, 0.75},
          Ellipsoid{{0, 0, 0}, {1, 0.5, 0.75}},
          ConvexHull(corners),
          HalfSpace{{-1, 2, 2}, -0.25},
          tests::make_box({1, 0.5, 0.75})};
}

void judge_bodies(Tally& tally, RandomSource& source, bool is_aligned) {
  const std::vector<Shape> shapes = shapes_of_all_kinds();
  for (const Shape& shape_a : shapes) {
    for (const Shape& shape_b : shapes) {
      Pose pose_a = tests::random_pose(1, source);
      Pose pose_b = tests::random_pose(1.5, source);
      if (is_aligned) {
        pose_a = pose_b = Pose::Identity();
        pose_b.translation() = source.lattice_point(-4, 4) / 2;
      }
      const CaseBody a(shape_a, pose_a);
      const CaseBody b(shape_b, pose_b);
      for (const Ask ask : {Ask::Any, Ask::Distance, Ask::Contacts})
        tally.judge(asking(ask, a, b), source);
    }
    const CaseBody a(shape_a, tests::random_pose(1, source));
    const Ray ray{source.vector(-3, 3), source.vector(-1, 1)};
    tally.judge(asking(Ask::Ray, a, ray), source);
    tally.judge(asking(Ask::Ray, a, Ray{ray.origin, a.pose.translation() - ray.origin}), source);
  }
}

/// Poses in special position, and some that are not.
Pose any_pose(int run, RandomSource& source) {
  Pose pose = run % 3 == 0 ? Pose::Identity() : tests::random_pose(1, source);
  if (run % 3 == 0) pose.translation() = source.lattice_point(-4, 4) / 4;
  return pose;
}

void judge_runs(Tally& tally, int runs, std::uint64_t seed) {
  RandomSource source(seed);
  const Mesh cube = tests::make_box({1, 1, 1});
  const Mesh torus = tests::make_torus(1, 0.3, 12, 8);
  const Mesh ball = tests::make_sphere(0.5, 5, 7);
  const Mesh pebble = tests::make_box({0.25, 0.125, 0.25});
  for (int run = 0; run < runs; ++run) {
    SCOPED_TRACE(run);
    judge_meshes(tally, source, cube, run % 2 == 0 ? cube : pebble, any_pose(run, source));
    judge_meshes(tally, source, torus, ball, any_pose(run + 1, source));
    const Mesh soup_a = tests::lattice_soup(8, 2, source),
               soup_b = tests::lattice_soup(8, 2, source);
    judge_meshes(tally, source, soup_a, soup_b, Pose::Identity());
    judge_rays_and_points(tally, source, torus, any_pose(run, source));
    judge_rays_and_points(tally, source, cube, any_pose(run, source));
    judge_bodies(tally, source, run % 2 == 1);
  }
}

/// Two meshes have as many regions of contact as they have, each with up to four contacts.
TEST(JudgedContacts, OfMeshesMayBeMoreThanFour) {
  const Mesh pier = tests::make_box({1, 0.5, 0.75});
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (const double x : {-2.0, 2.0}) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const Eigen::Vector3d& vertex : pier.vertices())
      vertices.emplace_back(vertex + Eigen::Vector3d(x, 0, 0));
    for (const TriangleIndices& of : pier.triangles())
      triangles.push_back({of[0] + first, of[1] + first, of[2] + first});
  }
  Pose above = Pose::Identity();
  above.translation() << 0, 0, 0.95;
  const Case query = asking(Ask::Contacts, CaseBody(Mesh(vertices, triangles), Pose::Identity()),
                            CaseBody(tests::make_box({2.75, 0.25, 0.25}), above));
  const std::optional<CaseAnswer> answer = answer_case(query);
  ASSERT_TRUE(answer && answer->manifold);
  EXPECT_GT(answer->manifold->size(), 4u);
  const Judgement judgement = Judge(query).judge(*answer, this_library());
  EXPECT_NE(judgement.verdict, Verdict::Wrong) << judgement.truth;
}

TEST(AnswerMutants, NoneIsCalledRight) {
  Tally tally;
  judge_runs(tally, 1, 1);
  EXPECT_GT(tally.wrong(), tally.all() / 2) << tally.text();
}

TEST(AnswerMutantsSlow, NoneIsCalledRight) {
  Tally tally;
  judge_runs(tally, 40, 2);
  EXPECT_GT(tally.wrong(), tally.all() / 2);
  std::printf("%zu mutants, %zu wrong\n%s", tally.all(), tally.wrong(), tally.text().c_str());
}

}  // namespace
}  // namespace graze::compare

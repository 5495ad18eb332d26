// What an engine with a planted bug gets wrong is found, classed and shrunk.

#include <graze/engine/cases/motion_case.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/shrink/shrink.h>
#include <graze/engine/compare/run/trial.h>
#include <gtest/gtest.h>

#include "tests/compare/engine_doubles.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze::compare {
namespace {

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

TEST_F(PlantedBug, AMissedContactIsShrunkWithItsMotion) {
  const RigidMotion comes(
      Pose(Eigen::Translation3d(5, 0.5, 0.0625)),
      {.centre = {5, 0.5, 0}, .shift = {-8, 0, 0}, .axis = {1, 2, 0}, .angle = 1});
  Case query = to_case_free(case_mesh(torus_, RigidMotion(Pose::Identity())),
                            case_mesh(sphere_, comes), true);
  query.answer.reset();
  const std::unique_ptr<Engine> still = make_motionless_engine("still");
  const Engine& engine = *still;
  const StillWrong is_still_wrong = [&](const Case& smaller) {
    const std::optional<CaseAnswer> answer = ask(engine, smaller);
    return answer && Judge(smaller).judge(*answer, engine.name()).verdict == Verdict::Wrong;
  };
  ASSERT_TRUE(is_still_wrong(query));
  const Judgement judgement = Judge(query).judge(*ask(engine, query), engine.name());
  const Case small = shrink(query, judgement.culprit, is_still_wrong);
  EXPECT_TRUE(is_still_wrong(small));
  EXPECT_EQ(triangles_of(small), 2u);
  EXPECT_TRUE(motion_of(std::get<CaseMesh>(*small.b)) == comes);
  EXPECT_EQ(to_json(parse_case(to_json(small), "memory")), to_json(small));
}

}  // namespace
}  // namespace graze::compare

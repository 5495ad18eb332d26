// Planted bugs about shapes of every kind: found, classified, shrunk, written and asked again.

#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/shrink/shape_numbers.h>
#include <graze/engine/compare/judge/shrink/shrink.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>
#include <tests/oracle/sampler.h>
#include <vector>

#include "tests/compare/engine_doubles.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze::compare {
namespace {

/// Of many corners and triangles, so that there is something to take away.
std::vector<Shape> one_of_each_shape() {
  std::vector<Eigen::Vector3d> corners;
  const Mesh ball = tests::make_sphere(1, 6, 9);
  corners.assign(ball.vertices().begin(), ball.vertices().end());
  return {Sphere{{0.125, 0, 0}, 1},
          Box{{1, 0.75, 0.5}},
          Capsule{0.5, 0.5},
          Cylinder{0.75, 1},
          Cone{1, 1},
          Ellipsoid{{0, 0.0625, 0}, {1, 0.75, 0.5}},
          ConvexHull(corners),
          HalfSpace{{-1, 0.25, 0.125}, -0.0625},
          tests::make_torus(1, 0.3, 12, 8)};
}

Case about(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b) {
  return {.note = "",
          .ask = Ask::Any,
          .settings = {},
          .a = CaseBody(a, pose_a),
          .b = CaseBody(b, pose_b),
          .answer = std::nullopt,
          .answered_by = {}};
}

/// By more than rounding.
bool is_wrong(const Engine& engine, const Case& query) {
  const std::optional<CaseAnswer> answer = ask(engine, query);
  if (!answer) return false;
  const Judgement judgement = Judge(query).judge(*answer, engine.name());
  return judgement.verdict == Verdict::Wrong && judgement.error_class == ErrorClass::Real;
}

/// More triangles than the error needs would be a fault; a mesh that is only there to be close by
/// needs one, and a hull the four corners without which there is none.
void expect_small(const Shape& shape) {
  if (shape.kind() == ShapeKind::Mesh) {
    EXPECT_LE(part_count(shape), 2u);
  }
  if (shape.kind() == ShapeKind::ConvexHull) {
    EXPECT_LE(part_count(shape), 5u);
  }
}

TEST(ShrinkBodies, AWrongSignIsFoundClassifiedShrunkAndReplayed) {
  const std::unique_ptr<Engine> engine = make_wrong_sign_engine("fcl");
  const std::vector<EngineEntry> engines = all_engines();
  const std::vector<Shape> shapes = one_of_each_shape();
  RandomSource source(11);
  std::size_t found = 0;
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      SCOPED_TRACE(std::string(name_of(a.kind())) + "/" + name_of(b.kind()));
      Case query = about(a, Pose::Identity(), b, Pose::Identity());
      for (int draw = 0; draw < 40 && !is_wrong(*engine, query); ++draw) {
        const Pose pose_a = tests::random_pose(0.25, source);
        query = about(a, pose_a, b, tests::random_pose(1.5, source));
      }
      if (!is_wrong(*engine, query)) continue;  // where it is right by chance
      ++found;
      const StillWrong still = [&](const Case& smaller) { return is_wrong(*engine, smaller); };
      Case small = shrink(query, std::nullopt, still);
      EXPECT_TRUE(is_wrong(*engine, small)) << "shrinking lost the disagreement";
      expect_small(as_bodies(small)->a.shape);
      expect_small(as_bodies(small)->b.shape);
      small.answer = ask(*engine, small);
      small.answered_by = engine->name();
      const Case back = parse_case(to_json(small), "memory");
      EXPECT_EQ(to_json(back), to_json(small)) << "another shape than was asked about";
      const std::vector<Testimony> all = try_case(back, engines);
      EXPECT_TRUE(all.front().is_recorded);
      EXPECT_EQ(all.front().judgement.verdict, Verdict::Wrong);
      EXPECT_EQ(all.front().judgement.error_class, ErrorClass::Real);
      EXPECT_EQ(all.at(1).judgement.verdict, Verdict::Right) << "graze";
    }
  }
  EXPECT_GT(found, 70u);
}

TEST(ShrinkBodies, NumbersAreOfTheShapeThatTheyMake) {
  for (const Shape& shape : one_of_each_shape()) {
    SCOPED_TRACE(name_of(shape.kind()));
    Shape same = shape;
    for (int i = 0; i < 8; ++i)
      same = with_numbers(same, numbers_of(same));
    EXPECT_EQ(numbers_of(with_numbers(same, numbers_of(same))), numbers_of(same));
    Pose pose = Pose::Identity();
    pose.translation() << 1, 2, 3;
    EXPECT_EQ(intersects({same, pose}, {shape, pose}), true);
  }
}

/// The predicate is what counts, whatever it is: "the mesh has at least so many triangles".
TEST(ShrinkBodies, KeepsTheDisagreementWhateverItIs) {
  const Shape mesh = tests::make_torus(1, 0.3, 12, 8);
  const Case query = about(mesh, Pose::Identity(), Shape(Sphere{{0, 0, 0}, 1}), Pose::Identity());
  for (const std::size_t least : {1u, 3u, 7u}) {
    const StillWrong holds = [&](const Case& smaller) {
      return part_count(as_bodies(smaller)->a.shape) >= least;
    };
    EXPECT_EQ(part_count(as_bodies(shrink(query, std::nullopt, holds))->a.shape), least);
  }
  const StillWrong never = [](const Case&) { return false; };
  EXPECT_EQ(part_count(as_bodies(shrink(query, std::nullopt, never))->a.shape), part_count(mesh));
}

}  // namespace
}  // namespace graze::compare

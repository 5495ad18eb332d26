// The judge on trial: answers about spheres and boxes.

#include <graze/engine/cases/to_case.h>
#include <graze/engine/compare/judge/rational/rational_box.h>
#include <graze/narrowphase/volumes/obb_overlap.h>
#include <gtest/gtest.h>

#include "tests/compare/judge/judged.h"
#include "tests/shapes/random_meshes.h"

namespace graze::compare {
namespace {

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
    if (!intersects(a, b)) {
      EXPECT_FALSE(overlap);
    }
    if (!overlap) {
      EXPECT_GT(squared_gap(exactly_by_frame(a), exactly_by_frame(b)), 0);
    }
  }
  EXPECT_GT(hits, 4u);
  EXPECT_LT(hits, 36u);
}

}  // namespace
}  // namespace graze::compare

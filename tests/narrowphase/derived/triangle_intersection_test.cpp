#include <graze/bvh/error.h>
#include <graze/narrowphase/triangle_intersection.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/crosscheck/corpus_run.h"
#include "tests/narrowphase/derived/value_faults.h"

namespace graze {
namespace {

const Triangle kFlat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TEST(TriangleIntersection, APoint) {
  const TriangleIntersection found = intersection(kFlat, {{1, 1, 0}, {1, 1, 1}, {2, 1, 1}});
  EXPECT_EQ(found.kind, IntersectionKind::Point);
  ASSERT_EQ(found.count, 1);
  EXPECT_EQ(found.corner[0], Eigen::Vector3d(1, 1, 0));
}

TEST(TriangleIntersection, ASegment) {
  const TriangleIntersection found = intersection(kFlat, {{1, 1, -1}, {1, 1, 1}, {9, 1, 1}});
  EXPECT_EQ(found.kind, IntersectionKind::Segment);
  ASSERT_EQ(found.count, 2);
  EXPECT_EQ(found.corner[0] + found.corner[1], Eigen::Vector3d(4, 2, 0));
}

TEST(TriangleIntersection, APolygonOfSixCorners) {
  const Triangle up{{0, 0, 2}, {6, 0, 2}, {3, 6, 2}};
  const Triangle down{{0, 4, 2}, {6, 4, 2}, {3, -2, 2}};
  const TriangleIntersection found = intersection(up, down);
  EXPECT_EQ(found.kind, IntersectionKind::Polygon);
  ASSERT_EQ(found.count, 6);
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (int i = 0; i < 6; ++i) {
    const Eigen::Vector3d side = found.corner[(i + 1) % 6] - found.corner[i];
    const Eigen::Vector3d next = found.corner[(i + 2) % 6] - found.corner[(i + 1) % 6];
    const Eigen::Vector3d turn = side.cross(next);
    EXPECT_GE(turn.dot(normal), 0);
    EXPECT_GT(turn.norm(), 0);
    normal = turn;
  }
}

TEST(TriangleIntersection, NothingAndDegenerateTriangles) {
  EXPECT_EQ(intersection(kFlat, {{1, 1, 1}, {1, 1, 2}, {2, 1, 1}}).kind, IntersectionKind::None);
  EXPECT_EQ(intersection(kFlat, {{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}).kind, IntersectionKind::Point);
  EXPECT_EQ(intersection(kFlat, {{1, 1, 0}, {2, 1, 0}, {3, 1, 0}}).kind, IntersectionKind::Segment);
  EXPECT_EQ(intersection({{0, 0, 0}, {4, 4, 4}, {1, 1, 1}}, {{0, 4, 4}, {4, 0, 0}, {2, 2, 2}}).kind,
            IntersectionKind::Point);
  EXPECT_EQ(intersection({{0, 0, 0}, {4, 4, 4}, {1, 1, 1}}, {{3, 3, 3}, {9, 9, 9}, {9, 9, 9}}).kind,
            IntersectionKind::Segment);
}

TEST(Law10TriangleIntersection, CoordinatesThatAreNotFiniteAreRefused) {
  for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (int i = 0; i < 9; ++i) {
      Triangle broken{{1, 1, -1}, {1, 1, 1}, {2, 1, 1}};
      Eigen::Vector3d* corner[] = {&broken.a, &broken.b, &broken.c};
      (*corner[i / 3])[i % 3] = bad;
      EXPECT_THROW(intersection(kFlat, broken), InputError) << i;
      EXPECT_THROW(intersection(broken, kFlat), InputError) << i;
    }
  }
}

class Law7TriangleIntersection
    : public testing::TestWithParam<oracle::Corpus<oracle::TrianglePair>> {};
class Law7TriangleIntersectionSlow : public Law7TriangleIntersection {};

TEST_P(Law7TriangleIntersection, AgreesWithRationalClipping) {
  crosscheck::run_corpus(GetParam(), 50, oracle::intersection_fault);
}
TEST_P(Law7TriangleIntersectionSlow, AgreesWithRationalClipping) {
  crosscheck::run_corpus(GetParam(), 1000, oracle::intersection_fault);
}

INSTANTIATE_TEST_SUITE_P(Derived, Law7TriangleIntersection,
                         testing::ValuesIn(oracle::pair_corpora()), crosscheck::CorpusName());
INSTANTIATE_TEST_SUITE_P(Derived, Law7TriangleIntersectionSlow,
                         testing::ValuesIn(oracle::pair_corpora()), crosscheck::CorpusName());

}  // namespace
}  // namespace graze

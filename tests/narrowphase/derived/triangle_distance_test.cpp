#include <graze/bvh/error.h>
#include <graze/narrowphase/derived/distance_stages.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/crosscheck/corpus_run.h"
#include "tests/narrowphase/derived/value_faults.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using narrowphase::decide_distance;
using narrowphase::Stage;

const Triangle kFlat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TEST(TriangleDistance, EachKindOfFeature) {
  const auto expect = [](const Triangle& b, double expected, Feature feature_a, Feature feature_b) {
    const TriangleDistance found = distance(kFlat, b);
    EXPECT_EQ(found.distance, expected);
    EXPECT_EQ(found.feature_a, feature_a);
    EXPECT_EQ(found.feature_b, feature_b);
    EXPECT_EQ((found.point_b - found.point_a).norm(), expected);
  };
  expect({{1, 1, 2}, {1, 2, 5}, {2, 1, 5}}, 2, Feature::Face, Feature::Vertex);
  expect({{-3, -4, 0}, {-9, -9, 1}, {-9, -8, 2}}, 5, Feature::Vertex, Feature::Vertex);
  expect({{2, -3, -4}, {3, -9, -9}, {1, -9, -9}}, 5, Feature::Edge, Feature::Vertex);
  expect({{2, -3, -1}, {2, -3, 1}, {2, -9, 0}}, 3, Feature::Edge, Feature::Edge);
}

TEST(TriangleDistance, TouchingIsZeroAndAHairApartIsNot) {
  EXPECT_EQ(distance(kFlat, {{1, 1, 0}, {1, 1, 1}, {2, 1, 1}}).distance, 0);
  const double above = std::nextafter(0.0, 1.0);
  const TriangleDistance hair = distance(kFlat, {{1, 1, above}, {1, 1, 1}, {2, 1, 1}});
  EXPECT_EQ(hair.distance, above);
  EXPECT_EQ(hair.point_a, Eigen::Vector3d(1, 1, 0));
}

TEST(TriangleDistance, ADistanceBelowTheSmallestDoubleIsNotZero) {
  const double tiny = std::nextafter(0.0, 1.0);
  // The edge x + y = 1 in units of the smallest double passes the origin at 0.7 of it.
  const Triangle slope{{tiny, 0, 0}, {0, tiny, 0}, {1, 1, 0}};
  const Triangle point{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  EXPECT_FALSE(intersects(slope, point));
  EXPECT_EQ(distance(slope, point).distance, tiny);
}

TEST(TriangleDistance, BeyondTheLargestDoubleItIsInfinite) {
  const double huge = 1.7e308;
  const Triangle here{{-huge, 0, 0}, {-huge, 1, 0}, {-huge, 0, 1}};
  const Triangle there{{huge, 0.25, 0.25}, {huge, 1, 0}, {huge, 0, 1}};
  EXPECT_EQ(distance(here, there).distance, HUGE_VAL);
  EXPECT_EQ(distance(here, there).point_a.x(), -huge);
}

TEST(Law6TriangleDistance, GenericPairsApartNeedNoExactStage) {
  RandomSource source(61);
  int exact = 0;
  for (int n = 0; n < 20000; ++n) {
    const auto point = [&](double x) -> Eigen::Vector3d {
      return source.vector(-1, 1) + Eigen::Vector3d(x, 0, 0);
    };
    const Eigen::Vector3d a0 = point(0), a1 = point(0), a2 = point(0);
    const Eigen::Vector3d b0 = point(2.5), b1 = point(2.5), b2 = point(2.5);
    const narrowphase::StagedDistance found = decide_distance({a0, a1, a2}, {b0, b1, b2});
    exact += found.stage == Stage::Exact;
  }
  EXPECT_LT(exact, 20);
}

TEST(Law6TriangleDistance, TiesAndIllConditionedPairsAreExact) {
  const Triangle parallel{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}};
  EXPECT_EQ(decide_distance(kFlat, parallel).stage, Stage::Exact);
  EXPECT_EQ(decide_distance(kFlat, kFlat).stage, Stage::Exact);
  const Triangle nearly_parallel{{1, -1, -1}, {3, -1, -1 + 1e-14}, {2, -5, -9}};
  EXPECT_EQ(decide_distance(kFlat, nearly_parallel).stage, Stage::Exact);
}

TEST(Law10TriangleDistance, CoordinatesThatAreNotFiniteAreRefused) {
  for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (int i = 0; i < 9; ++i) {
      Triangle far{{10, 10, 10}, {11, 10, 10}, {10, 12, 10}};
      Triangle near{{1, 1, -1}, {1, 1, 1}, {2, 1, 1}};
      for (Triangle* broken : {&far, &near}) {
        Eigen::Vector3d* corner[] = {&broken->a, &broken->b, &broken->c};
        (*corner[i / 3])[i % 3] = bad;
        EXPECT_THROW(distance(kFlat, *broken), InputError) << i;
        EXPECT_THROW(distance(*broken, kFlat), InputError) << i;
      }
    }
  }
}

class Law7TriangleDistance : public testing::TestWithParam<oracle::Corpus<oracle::TrianglePair>> {};
class Law7TriangleDistanceSlow : public Law7TriangleDistance {};

TEST_P(Law7TriangleDistance, AgreesWithRationalArithmetic) {
  crosscheck::run_corpus(GetParam(), 40, oracle::distance_fault);
}
TEST_P(Law7TriangleDistanceSlow, AgreesWithRationalArithmetic) {
  crosscheck::run_corpus(GetParam(), 1000, oracle::distance_fault);
}

/// The corpus is about intersection; moved apart, its hard shapes are about distance.
std::string fault_when_apart(const oracle::TrianglePair& pair, std::uint64_t seed) {
  RandomSource source(seed);
  double size = 0;
  for (const Triangle& t : {pair.a, pair.b}) {
    for (const Eigen::Vector3d& corner : {t.a, t.b, t.c})
      size = std::max(size, corner.cwiseAbs().maxCoeff());
  }
  const Eigen::Vector3d away = source.lattice_point(-3, 3) * (0.25 * size);
  const oracle::TrianglePair apart{pair.a, oracle::moved(pair.b, away)};
  const bool is_finite = apart.b.a.allFinite() && apart.b.b.allFinite() && apart.b.c.allFinite();
  return is_finite ? oracle::distance_fault(apart) : "";
}

void run_apart(const oracle::Corpus<oracle::TrianglePair>& corpus, int count) {
  std::uint64_t seed = 0;
  crosscheck::run_corpus(corpus, count, [&](const oracle::TrianglePair& pair) {
    return fault_when_apart(pair, seed++);
  });
}

TEST_P(Law7TriangleDistance, OfShapesMovedApart) {
  run_apart(GetParam(), 40);
}
TEST_P(Law7TriangleDistanceSlow, OfShapesMovedApart) {
  run_apart(GetParam(), 1000);
}

INSTANTIATE_TEST_SUITE_P(Derived, Law7TriangleDistance, testing::ValuesIn(oracle::pair_corpora()),
                         crosscheck::CorpusName());
INSTANTIATE_TEST_SUITE_P(Derived, Law7TriangleDistanceSlow,
                         testing::ValuesIn(oracle::pair_corpora()), crosscheck::CorpusName());

}  // namespace
}  // namespace graze

#include <graze/bvh/error.h>
#include <graze/narrowphase/derived/distance_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/crosscheck/corpus_run.h"
#include "tests/crosscheck/permutations.h"
#include "tests/narrowphase/derived/rational_triangles.h"
#include "tests/oracle/case_text.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using narrowphase::decide_distance;
using narrowphase::Stage;
using oracle::exactly;

const Triangle kFlat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

bool are_bits_equal(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  return std::memcmp(p.data(), q.data(), 3 * sizeof(double)) == 0;
}

bool are_same(const TriangleDistance& x, const TriangleDistance& y) {
  return x.distance == y.distance && are_bits_equal(x.point_a, y.point_a) &&
         are_bits_equal(x.point_b, y.point_b) && x.feature_a == y.feature_a &&
         x.feature_b == y.feature_b;
}

TriangleDistance mirrored(const TriangleDistance& x) {
  return {x.distance, x.point_b, x.point_a, x.feature_b, x.feature_a};
}

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

/// |value^2 - square| as far as a root that is off by `reach` explains.
bool is_root(double value, const mpq_class& square, const mpq_class& reach) {
  const mpq_class low = mpq_class(value) - reach;
  const mpq_class high = mpq_class(value) + reach;
  return square <= high * high && (low <= 0 || low * low <= square);
}

bool lies_on(const Eigen::Vector3d& point, const Triangle& t, const mpq_class& reach) {
  return oracle::squared_distance(exactly(point), t) <= 3 * reach * reach;
}

const char* fault_of(const oracle::TrianglePair& pair, const TriangleDistance& found) {
  const mpq_class ulp = oracle::ulp_of_coordinates(pair.a, pair.b);
  if ((found.distance == 0) != intersects(pair.a, pair.b)) {
    return "law 7: zero does not mean that they intersect";
  }
  if (!lies_on(found.point_a, pair.a, 2 * ulp) || !lies_on(found.point_b, pair.b, 2 * ulp)) {
    return "law 7: a witness is off its triangle by more than 2 ulp";
  }
  if (found.distance == 0) {
    return are_bits_equal(found.point_a, found.point_b) ? nullptr : "law 7: two witnesses of zero";
  }
  const oracle::RationalDistance exact = oracle::rational_distance(pair.a, pair.b);
  if (std::isfinite(found.distance) &&
      !is_root(found.distance, exact.square, 4 * oracle::ulp_of_differences(pair.a, pair.b))) {
    return "law 7: the distance is off by more than 4 ulp";
  }
  if (exact.nearest.size() > 1) {
    // Each of the witnesses is off by at most 2 ulp in each coordinate.
    const mpq_class between =
        oracle::squared_distance(exactly(found.point_a), exactly(found.point_b));
    const mpq_class reach = 8 * ulp + 4 * oracle::ulp_of_differences(pair.a, pair.b);
    return !std::isfinite(found.distance) || is_root(found.distance, between, reach)
               ? nullptr
               : "law 7: the witnesses disagree with the distance";
  }
  const bool are_near = oracle::are_within(exact.nearest[0].a, found.point_a, 2 * ulp) &&
                        oracle::are_within(exact.nearest[0].b, found.point_b, 2 * ulp);
  return are_near ? nullptr : "law 7: a witness is off by more than 2 ulp";
}

std::string fault_of(const oracle::TrianglePair& pair) {
  const TriangleDistance found = distance(pair.a, pair.b);
  const char* fault = fault_of(pair, found);
  if (fault == nullptr) {
    fault = fault_of(pair, narrowphase::distance_exactly(pair.a, pair.b));
  }
  const auto b_orders = crosscheck::permutations(pair.b);
  for (const Triangle& a : crosscheck::permutations(pair.a)) {
    for (int i = 1; i < 6; i += 2) {
      if (!are_same(distance(a, b_orders[i]), found) ||
          !are_same(mirrored(distance(b_orders[i], a)), found)) {
        fault = "law 4: another order changes the result";
      }
    }
  }
  if (fault == nullptr) return "";
  return std::string(fault) + ":\n" + to_text(pair, intersects(pair.a, pair.b));
}

class Law7TriangleDistance : public testing::TestWithParam<oracle::Corpus<oracle::TrianglePair>> {};
class Law7TriangleDistanceSlow : public Law7TriangleDistance {};

TEST_P(Law7TriangleDistance, AgreesWithRationalArithmetic) {
  crosscheck::run_corpus(GetParam(), 40,
                         [](const oracle::TrianglePair& pair) { return fault_of(pair); });
}
TEST_P(Law7TriangleDistanceSlow, AgreesWithRationalArithmetic) {
  crosscheck::run_corpus(GetParam(), 1000,
                         [](const oracle::TrianglePair& pair) { return fault_of(pair); });
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
  return is_finite ? fault_of(apart) : "";
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

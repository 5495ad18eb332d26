// The distance of a point and a triangle beside rational arithmetic.

#include <graze/narrowphase/derived/distance_stages.h>
#include <graze/narrowphase/derived/point_distance.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/narrowphase/derived/rational_triangles.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using narrowphase::decide_distance;
using narrowphase::PointDistance;
using narrowphase::Stage;

const Triangle kFlat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TEST(PointDistance, EachKindOfFeature) {
  const auto expect = [](const Eigen::Vector3d& point, double distance, Feature feature,
                         const Eigen::Vector3d& nearest) {
    const PointDistance found = decide_distance(point, kFlat);
    EXPECT_EQ(found.distance, distance);
    EXPECT_EQ(found.feature, feature);
    EXPECT_EQ(found.nearest, nearest);
  };
  expect({1, 1, 2}, 2, Feature::Face, {1, 1, 0});
  expect({1, 1, -2}, 2, Feature::Face, {1, 1, 0});
  expect({-3, -4, 0}, 5, Feature::Vertex, {0, 0, 0});
  expect({7, 0, 4}, 5, Feature::Vertex, {4, 0, 0});
  expect({0, 8, -3}, 5, Feature::Vertex, {0, 4, 0});
  expect({2, -3, 4}, 5, Feature::Edge, {2, 0, 0});
  expect({-4, 1, 3}, 5, Feature::Edge, {0, 1, 0});
  expect({3, 3, 0}, std::sqrt(2), Feature::Edge, {2, 2, 0});
  expect({1, 1, 0}, 0, Feature::Face, {1, 1, 0});
  expect({2, 2, 0}, 0, Feature::Edge, {2, 2, 0});
  expect({0, 4, 0}, 0, Feature::Vertex, {0, 4, 0});
}

TEST(PointDistance, PointsAtRandomNeedNoExactStage) {
  RandomSource source(21);
  int exact = 0;
  for (int n = 0; n < 20000; ++n) {
    const Triangle triangle{source.vector(-1, 1), source.vector(-1, 1), source.vector(-1, 1)};
    exact += decide_distance(source.vector(-2, 2), triangle).stage == Stage::Exact;
  }
  EXPECT_LT(exact, 20);
}

/// A triangle and a point, on a lattice or not, of any size; some triangles have no area.
struct Input {
  Triangle triangle;
  Eigen::Vector3d point;
};

Input random_input(int n, RandomSource& source) {
  constexpr std::array kScales{1.0, 1.0, 0x1p-300, 0x1p+300, 1e-308, 1e307, 0.1, 5e-324};
  const double scale = kScales[static_cast<std::size_t>(n / 4) % kScales.size()];
  const bool is_on_lattice = n % 2 == 0;
  const auto corner = [&]() -> Eigen::Vector3d {
    return scale * (is_on_lattice ? source.lattice_point(-2, 2) : source.vector(-2, 2));
  };
  Input input{{corner(), corner(), corner()}, corner()};
  if (n % 4 == 1) {  // near the plane, and nearly above edges
    const double s = source.uniform(-0.5, 1.5), t = source.integer(0, 2) / 2;
    input.point = input.triangle.a + s * (input.triangle.b - input.triangle.a) +
                  t * (input.triangle.c - input.triangle.a);
  }
  return input;
}

TEST(Law7PointDistance, AgreesWithRationalArithmetic) {
  RandomSource source(22);
  int touching = 0, apart = 0, rounded = 0;
  for (int n = 0; n < 4000; ++n) {
    const auto [triangle, point] = random_input(n, source);
    if (!point.allFinite()) continue;
    const PointDistance found = decide_distance(point, triangle);
    const Triangle as_triangle{point, point, point};
    const mpq_class square = oracle::squared_distance(oracle::exactly(point), triangle);
    ASSERT_EQ(found.distance == 0, square == 0) << n;
    // |found - d| <= e if (found - e)^2 <= d^2 <= (found + e)^2.
    const mpq_class error = 4 * oracle::ulp_of_differences(as_triangle, triangle);
    const mpq_class low = std::max<mpq_class>(mpq_class(found.distance) - error, 0);
    const mpq_class high = mpq_class(found.distance) + error;
    EXPECT_TRUE(low * low <= square) << n;
    EXPECT_TRUE(high * high >= square) << n;
    // The nearest point is unique: the exact stage has it to half an ulp.
    const TriangleDistance exact = narrowphase::distance_exactly(as_triangle, triangle);
    const mpq_class reach = 3 * oracle::ulp_of_coordinates(as_triangle, triangle);
    EXPECT_TRUE(oracle::are_within(oracle::exactly(exact.point_b), found.nearest, reach)) << n;
    (square == 0 ? touching : apart) += 1;
    rounded += found.stage == Stage::Triage;
    // Law 4.
    for (const Triangle& same : {Triangle{triangle.b, triangle.c, triangle.a},
                                 Triangle{triangle.c, triangle.b, triangle.a}}) {
      const PointDistance again = decide_distance(point, same);
      EXPECT_EQ(again.distance, found.distance);
      EXPECT_EQ(again.nearest, found.nearest);
      EXPECT_EQ(again.feature, found.feature);
    }
  }
  EXPECT_GT(touching, 100);
  EXPECT_GT(apart, 2000);
  EXPECT_GT(rounded, 1000);
}

}  // namespace
}  // namespace graze

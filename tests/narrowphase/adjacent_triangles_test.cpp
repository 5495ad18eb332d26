#include <graze/engine/compare/referee.h>
#include <graze/narrowphase/predicates/orientation_stages.h>
#include <graze/narrowphase/triangle_pair/adjacent_triangles.h>
#include <gtest/gtest.h>
#include <cmath>

#include "tests/shapes/random_source.h"

namespace graze::narrowphase {
namespace {

using compare::referee_intersects;

TEST(AdjacentTriangles, SharedVertex) {
  const Triangle flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_FALSE(intersect_beyond_vertex(flat, {{0, 0, 0}, {1, 1, 1}, {2, 1, 1}}));
  EXPECT_TRUE(intersect_beyond_vertex(flat, {{0, 0, 0}, {1, 1, 1}, {1, 1, -1}}));
  EXPECT_TRUE(intersect_beyond_vertex(flat, {{0, 0, 0}, {1, 1, 0}, {-1, -2, 1}}))
      << "an edge in the face";
  EXPECT_FALSE(intersect_beyond_vertex(flat, {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}))
      << "coplanar, opposite";
  EXPECT_TRUE(intersect_beyond_vertex(flat, {{0, 0, 0}, {2, 0, 0}, {0, -1, 0}})) << "along an edge";
}

TEST(AdjacentTriangles, SharedEdge) {
  const Triangle flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_FALSE(intersect_beyond_edge(flat, {{0, 0, 0}, {4, 0, 0}, {0, 4, 1e-300}}));
  EXPECT_FALSE(intersect_beyond_edge(flat, {{0, 0, 0}, {4, 0, 0}, {0, -4, 0}}));
  EXPECT_TRUE(intersect_beyond_edge(flat, {{0, 0, 0}, {4, 0, 0}, {9, 4, 0}}));
  EXPECT_FALSE(intersect_beyond_edge(flat, {{0, 0, 0}, {4, 0, 0}, {9, 0, 0}}))
      << "a segment on the line";
}

/// The point at a small part of the way from the shared vertex.
Eigen::Vector3d near(const Eigen::Vector3d& vertex, const Eigen::Vector3d& point) {
  return vertex + (point - vertex) * 0x1p-12;
}

/// Whether `from`, shrunk towards its vertex a, still reaches into `into` with what was its far
/// side. On a small lattice any common point has its like at this scale, because both triangles are
/// star-shaped about the shared vertex.
bool shrunken_far_side_meets(const Triangle& from, const Triangle& into) {
  const Eigen::Vector3d b = near(from.a, from.b);
  const Eigen::Vector3d c = near(from.a, from.c);
  if (!is_degenerate(from)) return referee_intersects(Triangle{b, c, c}, into);
  return (b != from.a && referee_intersects(Triangle{b, b, b}, into)) ||
         (c != from.a && referee_intersects(Triangle{c, c, c}, into));
}

TEST(AdjacentTriangles, SharedVertexAgreesWithTheRefereeAtSmallScale) {
  RandomSource source(1);
  int beyond = 0;
  for (int n = 0; n < 20000; ++n) {
    const auto point = [&] { return source.lattice_point(-2, 2); };
    const Eigen::Vector3d v = point();
    const Triangle a{v, point(), point()};
    const Triangle b{v, point(), point()};
    const bool expected = shrunken_far_side_meets(a, b);
    ASSERT_EQ(intersect_beyond_vertex(a, b), expected) << n;
    ASSERT_EQ(intersect_beyond_vertex(b, a), expected) << n;
    beyond += expected;
  }
  EXPECT_GT(beyond, 2000);
  EXPECT_LT(beyond, 18000);
}

// Beyond the edge means a point of either triangle off it: one of A shrunk towards the edge's
// middle, or, for segments, one beyond an end.
TEST(AdjacentTriangles, SharedEdgeAgreesWithTheRefereeAtSmallScale) {
  RandomSource source(2);
  int beyond = 0;
  for (int n = 0; n < 20000; ++n) {
    const auto point = [&] { return source.lattice_point(-1, 1); };
    const Eigen::Vector3d v = point(), w = point();
    if (v == w) continue;
    const Triangle a{v, w, point()};
    const Triangle b{v, w, point()};
    bool expected = false;
    if (!is_degenerate(a)) {
      const Eigen::Vector3d p = near(0.5 * (v + w), a.c);
      expected = referee_intersects(Triangle{p, p, p}, b);
    } else if (is_degenerate(b)) {
      for (const auto& [end, other] : {std::pair{v, w}, std::pair{w, v}}) {
        const Eigen::Vector3d p = end + (end - other) * 0x1p-12;
        expected |=
            referee_intersects(Triangle{p, p, p}, a) && referee_intersects(Triangle{p, p, p}, b);
      }
    }
    ASSERT_EQ(intersect_beyond_edge(a, b), expected) << n;
    ASSERT_EQ(intersect_beyond_edge(b, a), expected) << n;
    beyond += expected;
  }
  EXPECT_GT(beyond, 1000);
}

// A sign is the exact one, and is there where the filter of one pair has one that is not zero.
TEST(AdjacentTriangles, SidesOfAFanAreExactWhereTheyAreSure) {
  RandomSource source(3);
  int sure = 0, unsure = 0;
  for (int n = 0; n < 40000; ++n) {
    const double scale = std::pow(10, source.uniform(-160, 150));
    const auto point = [&]() -> Point2 { return {source.uniform(-1, 1), source.uniform(-1, 1)}; };
    const Point2 vertex = point(), way = point();
    // Half of them nearly on one line through the vertex.
    const auto other = [&]() -> Point2 {
      if (n % 2 == 0) return point();
      const double along = source.uniform(-1, 1), off = std::pow(10, source.uniform(-20, -12));
      return {vertex.x + along * way.x + off * way.y, vertex.y + along * way.y - off * way.x};
    };
    const auto scaled = [&](Point2 p) -> Point2 { return {scale * p.x, scale * p.y}; };
    const Point2 v = scaled(vertex),
                 p[4] = {scaled(other()), scaled(other()), scaled(other()), scaled(other())};
    const FanSides sides = fan_filter(v, p[0], p[1], p[2], p[3]);
    const auto expect_sign = [&](int sign, Point2 from, Point2 to) {
      if (sign != 0) {
        ASSERT_EQ(static_cast<Sign>(sign), orientation_2d(v, from, to)) << n;
      }
      ASSERT_EQ(sign, static_cast<int>(orientation_2d_filter(v, from, to).value_or(Sign::Zero)));
      ++(sign != 0 ? sure : unsure);
    };
    expect_sign(sides.a_b, p[0], p[1]), expect_sign(sides.c_d, p[2], p[3]);
    expect_sign(sides.a_c, p[0], p[2]), expect_sign(sides.a_d, p[0], p[3]);
    expect_sign(sides.b_c, p[1], p[2]), expect_sign(sides.b_d, p[1], p[3]);
  }
  EXPECT_GT(sure, 100000);
  EXPECT_GT(unsure, 10000);
}

}  // namespace
}  // namespace graze::narrowphase

// How far a triangle is from a ball, beside rational numbers: both bounds hold, and are as near to
// each other as is promised, where the two all but touch as anywhere.

#include <graze/narrowphase/convex/gap/ball_gap.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/narrowphase/derived/rational_triangles.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using narrowphase::ball_gap;
using narrowphase::BallGap;

struct Beside {
  Sphere ball;
  Triangle triangle;
  double largest_length;
};

double largest_length(const Sphere& ball, const Triangle& t) {
  double most = ball.radius;
  for (const Vector3d* corner : {&t.a, &t.b, &t.c})
    most = std::max(most, (*corner - ball.centre).cwiseAbs().maxCoeff());
  return most;
}

/// A ball whose surface is about `gap` radii off a corner, an edge or the face of a triangle.
Beside drawn(RandomSource& source, double flat, double unit) {
  Vector3d c[3];
  for (Vector3d& corner : c)
    corner = source.vector(-1, 1);
  if (flat < 1) c[2] = c[0] + (c[1] - c[0]) * source.uniform(0, 1) + source.vector(-1, 1) * flat;
  const double radius = std::pow(10.0, source.uniform(-4, 2));
  const double gap = std::pow(10.0, source.uniform(-30, -1)) * (source.integer(0, 3) - 1);
  const int kind = static_cast<int>(source.integer(0, 2));
  const double w[3] = {source.uniform(0.1, 1), kind < 2 ? source.uniform(0.1, 1) : 0,
                       kind < 1 ? source.uniform(0.1, 1) : 0};
  const Vector3d foot = (w[0] * c[0] + w[1] * c[1] + w[2] * c[2]) / (w[0] + w[1] + w[2]);
  const Vector3d edge = (c[1] - c[0]).normalized();
  const Vector3d normal = edge.cross(c[2] - c[0]).normalized();
  const Vector3d out = -(c[2] - c[0] - edge * edge.dot(c[2] - c[0])).normalized();
  Vector3d away = normal;
  if (kind == 1) away = (out + normal * source.uniform(-1, 1)).normalized();
  if (kind == 2) away = (out - edge + normal * source.uniform(-1, 1)).normalized();
  Beside beside{{(foot + away * (radius * (1 + gap))) * unit, radius * unit},
                {c[0] * unit, c[1] * unit, c[2] * unit},
                0};
  beside.largest_length = largest_length(beside.ball, beside.triangle);
  return beside;
}

/// Exactly: whether r + gap is at most the distance, or at least that.
bool is_at_most(const mpq_class& radius, double gap, const mpq_class& square) {
  const mpq_class sum = radius + mpq_class(gap);
  return sum <= 0 || sum * sum <= square;
}

bool is_at_least(const mpq_class& radius, double gap, const mpq_class& square) {
  const mpq_class sum = radius + mpq_class(gap);
  return sum >= 0 && sum * sum >= square;
}

void expect_proved(const Beside& beside, const char* label) {
  const BallGap gap = ball_gap(beside.ball, beside.triangle);
  const mpq_class square =
      oracle::squared_distance(oracle::exactly(beside.ball.centre), beside.triangle);
  const mpq_class radius(beside.ball.radius);
  EXPECT_TRUE(is_at_most(radius, gap.lower, square)) << label << gap.lower << " " << gap.upper;
  EXPECT_TRUE(is_at_least(radius, gap.upper, square)) << label << gap.lower << " " << gap.upper;
}

TEST(BallGap, BothBoundsHoldAndAreNearEachOther) {
  RandomSource source(181);
  for (int n = 0; n < 4000; ++n) {
    const Beside beside = drawn(source, 1, 1);
    expect_proved(beside, "");
    const BallGap gap = ball_gap(beside.ball, beside.triangle);
    const double most = 0x1p-90 * beside.largest_length + 0x1p-48 * std::abs(gap.upper);
    if (gap.upper > -beside.ball.radius / 2) {
      EXPECT_LE(gap.upper - gap.lower, most) << n;
    }
  }
}

TEST(BallGap, BothBoundsHoldOfTrianglesWithoutWidth) {
  RandomSource source(182);
  for (int n = 0; n < 4000; ++n)
    expect_proved(drawn(source, std::pow(10.0, source.uniform(-40, 0)), 1), "thin ");
  for (int n = 0; n < 200; ++n) {
    Beside beside = drawn(source, 1, 1);
    beside.triangle.c = n % 2 == 0 ? beside.triangle.a : beside.triangle.b;
    expect_proved(beside, "segment ");
    beside.triangle.b = beside.triangle.c = beside.triangle.a;
    expect_proved(beside, "point ");
  }
}

TEST(BallGap, BothBoundsHoldAtAnySize) {
  RandomSource source(183);
  for (const double unit : {1e-307, 1e-150, 1e-8, 1e8, 1e97}) {
    for (int n = 0; n < 300; ++n)
      expect_proved(drawn(source, 1, unit), "size ");
  }
}

TEST(BallGap, OfPowersOfTwoItIsExactButForItsRounding) {
  const Triangle floor{{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}};
  for (const int power : {-20, -40, -52}) {
    const double expected = std::ldexp(1.0, power);
    const BallGap gap = ball_gap({{0, 0, 1 + expected}, 1}, floor);
    EXPECT_NEAR(gap.lower, expected, expected * 0x1p-36);
    EXPECT_NEAR(gap.upper, expected, expected * 0x1p-36);
    EXPECT_EQ(gap.normal.z, -1);
    EXPECT_EQ(gap.to_point.z, -1 - expected);
  }
  EXPECT_LT(ball_gap({{0, 0, 1}, 1}, floor).lower, 0);
  EXPECT_LT(ball_gap({{0, 0, 0}, 1}, floor).upper, -0.9);
}

}  // namespace
}  // namespace graze

#include <graze/bvh/error.h>
#include <graze/narrowphase/volumes/spheres/triangle_sphere_stages.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/narrowphase/volumes/rational_spheres.h"
#include "tests/narrowphase/volumes/volume_source.h"

namespace graze {
namespace {

using narrowphase::Decision;
using narrowphase::intersects_exactly;
using narrowphase::Stage;
using narrowphase::triage;
using narrowphase::Verdict;

TEST(Law2TriangleSphere, AgreesWithRationalsOnEveryKindOfNumber) {
  for (Numbers kind : kEveryKind) {
    VolumeSource source(kind, 1);
    int hits = 0;
    for (int n = 0; n < 1500; ++n) {
      Triangle triangle = source.triangle();
      if (n % 8 == 1) triangle.c = triangle.b;
      if (n % 16 == 2) triangle.c = triangle.b = triangle.a;
      if (n % 8 == 3) triangle.c = 2 * triangle.b - triangle.a;
      if (!triangle.c.allFinite()) continue;
      const Sphere sphere = source.sphere();
      const bool expected = oracle::overlap(triangle, sphere);
      hits += expected;
      ASSERT_EQ(intersects(triangle, sphere), expected) << static_cast<int>(kind) << ", " << n;
      ASSERT_EQ(intersects_exactly(triangle, sphere), expected);
    }
    EXPECT_GT(hits, 100) << static_cast<int>(kind);
    EXPECT_LT(hits, 1400) << static_cast<int>(kind);
  }
}

/// An integer matrix with orthogonal columns of one integer length: a quaternion of integers, not
/// divided by its norm. What is built of integers in its frame has integer coordinates outside.
struct IntegerRotation {
  Eigen::Matrix3d matrix;
  double length;
};

IntegerRotation integer_rotation(RandomSource& random) {
  const double w = random.integer(1, 4), x = random.integer(-3, 3);
  const double y = random.integer(-3, 3), z = random.integer(-3, 3);
  IntegerRotation result;
  result.length = w * w + x * x + y * y + z * z;
  result.matrix << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x), 2 * (x * z - w * y),
      2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return result;
}

/// A triangle and a centre at a distance that is an integer.
struct Grazing {
  Triangle triangle;
  Eigen::Vector3d centre;
  double distance;
};

Grazing above_face(RandomSource& random) {
  const double height = random.integer(1, 20);
  return {{{-40, -35, 0}, {50, -30, 0}, {3, 60, 0}}, {2, 3, height}, height};
}

Grazing beside_edge(RandomSource& random) {
  const double k = random.integer(1, 9);
  const double x = random.integer(-39, 39);
  const double up = random.integer(0, 1) == 0 ? 4 : -4;
  return {{{-40, 0, 0}, {40, 0, 0}, {random.integer(-99, 99), 70, 0}}, {x, -3 * k, up * k}, 5 * k};
}

Grazing before_vertex(RandomSource& random) {
  const double k = random.integer(1, 9);
  return {{{0, 0, 0}, {50, random.integer(-9, 9), 0}, {random.integer(-9, 9), 60, 0}},
          {-2 * k, -3 * k, 6 * k},
          7 * k};
}

Grazing beside_segment(RandomSource& random) {
  Grazing result = beside_edge(random);
  result.triangle.c = {random.integer(-40, 40), 0, 0};
  return result;
}

/// Turned by integers, moved, its corners in any order, and scaled by a power of two.
Grazing moved(const Grazing& local, RandomSource& random) {
  const IntegerRotation rotation = integer_rotation(random);
  const Eigen::Vector3d t = random.lattice_point(-1000, 1000);
  const double scale = std::ldexp(1.0, static_cast<int>(random.integer(-60, 60)));
  const auto place = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return (rotation.matrix * p + t) * scale;
  };
  const Triangle placed{place(local.triangle.a), place(local.triangle.b), place(local.triangle.c)};
  Grazing result{placed, place(local.centre), local.distance * rotation.length * scale};
  const int order = static_cast<int>(random.integer(0, 2));
  if (order == 1) result.triangle = {placed.c, placed.a, placed.b};
  if (order == 2) result.triangle = {placed.b, placed.a, placed.c};
  return result;
}

TEST(Law2TriangleSphere, TouchingCountsToTheLastBit) {
  RandomSource random(2);
  for (const auto& make : {above_face, beside_edge, before_vertex, beside_segment}) {
    for (int n = 0; n < 600; ++n) {
      const Grazing grazing = moved(make(random), random);
      const auto decide = [&](double radius) {
        return narrowphase::decide(grazing.triangle, Sphere{grazing.centre, radius});
      };
      const Decision touching = decide(grazing.distance);
      ASSERT_TRUE(touching.is_hit) << n;
      ASSERT_EQ(touching.stage, Stage::Exact) << n;
      ASSERT_FALSE(decide(next_below(grazing.distance)).is_hit) << n;
      ASSERT_TRUE(decide(next_above(grazing.distance)).is_hit) << n;
      ASSERT_FALSE(
          oracle::overlap(grazing.triangle, Sphere{grazing.centre, next_below(grazing.distance)}))
          << n;
      const Decision apart = decide(grazing.distance * (1 - 1e-9));
      const Decision crossing = decide(grazing.distance * (1 + 1e-9));
      ASSERT_FALSE(apart.is_hit) << n;
      ASSERT_EQ(apart.stage, Stage::Triage) << n;
      ASSERT_TRUE(crossing.is_hit) << n;
      ASSERT_EQ(crossing.stage, Stage::Triage) << n;
    }
  }
}

TEST(Law2TriangleSphere, APointIsASphereOfRadiusZero) {
  const Triangle triangle{{0, 0, 0}, {3, 0, 0}, {0, 3, 3}};
  EXPECT_TRUE(intersects(triangle, Sphere{{1, 1, 1}, 0})) << "on an edge";
  EXPECT_TRUE(intersects(triangle, Sphere{{0.5, 1, 1}, 0})) << "on the face";
  EXPECT_FALSE(intersects(triangle, Sphere{{0.5, 1, next_above(1)}, 0}));
  EXPECT_FALSE(intersects(triangle, Sphere{{0.5, 1, 1 + 0x1p-40}, 0x1p-41}));
  EXPECT_TRUE(intersects({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, Sphere{{1, 2, 3}, 0}));
}

// The square of the normal is so small a number that its root has few right digits.
TEST(Law2TriangleSphere, AUnitBallOnATriangleWhoseSquaredNormalUnderflows) {
  RandomSource random(7);
  for (int exponent = -290; exponent <= -240; ++exponent) {
    for (int n = 0; n < 40; ++n) {
      const double scale = std::ldexp(random.uniform(1, 2), exponent);
      const Triangle t{
          {-3 * scale, -2 * scale, 0}, {5 * scale, -3 * scale, 0}, {scale, 7 * scale, 0}};
      ASSERT_TRUE(intersects(t, Sphere{{0, 0, 1}, 1})) << exponent;
      ASSERT_FALSE(intersects(t, Sphere{{0, 0, 1}, next_below(1)})) << exponent;
    }
  }
}

TEST(Law2TriangleSphere, NeedlesAndNearlyFlatTriangles) {
  VolumeSource source(Numbers::Generic, 3);
  for (int n = 0; n < 1500; ++n) {
    Triangle t = source.triangle();
    const double along = source.coordinate() * 2;
    const double off = std::ldexp(source.coordinate(), -static_cast<int>(n % 60));
    t.c = t.a + along * (t.b - t.a) + off * source.point();
    const Eigen::Vector3d centre = source.point();
    // The distance from a point of the triangle: often very nearly that from the triangle.
    const double radius = (t.a + 0.25 * (t.b - t.a) - centre).norm();
    for (double r : {radius, next_below(radius), next_above(radius), 0.9 * radius}) {
      const Sphere sphere{centre, r};
      ASSERT_EQ(intersects(t, sphere), oracle::overlap(t, sphere)) << n;
      const Verdict verdict = triage(t, sphere);
      if (verdict == Verdict::Unsure) continue;
      ASSERT_EQ(verdict == Verdict::Yes, oracle::overlap(t, sphere)) << n;
    }
  }
}

/// The foot of the centre as doubles give it, so that the gap is a rounding error or so.
TEST(Law2TriangleSphere, RadiiWithinARoundingErrorOfTheDistance) {
  VolumeSource source(Numbers::Generic, 4);
  int exact = 0;
  for (int n = 0; n < 2000; ++n) {
    const Triangle t = source.triangle();
    const Eigen::Vector3d normal = (t.b - t.a).cross(t.c - t.a).normalized();
    const double height = source.coordinate();
    const double u = source.random().uniform(0, 0.5), v = source.random().uniform(0, 0.5);
    const Eigen::Vector3d centre = t.a + u * (t.b - t.a) + v * (t.c - t.a) + height * normal;
    double radius = std::abs(height);
    for (int step = 0; step < 3; ++step)
      radius = next_below(radius);
    for (int step = 0; step < 7; ++step, radius = next_above(radius)) {
      const Decision decision = narrowphase::decide(t, Sphere{centre, radius});
      exact += decision.stage == Stage::Exact;
      ASSERT_EQ(decision.is_hit, oracle::overlap(t, Sphere{centre, radius})) << n;
    }
  }
  EXPECT_GT(exact, 5000) << "these should be beyond rounded arithmetic";
}

TEST(Law4TriangleSphere, ReorderingVerticesChangesNothing) {
  for (Numbers kind : kEveryKind) {
    VolumeSource source(kind, 5);
    for (int n = 0; n < 400; ++n) {
      const Triangle t = source.triangle();
      const Sphere sphere = source.sphere();
      const bool expected = intersects(t, sphere);
      for (const Triangle& s :
           {Triangle{t.b, t.c, t.a}, Triangle{t.c, t.b, t.a}, Triangle{t.b, t.a, t.c}}) {
        ASSERT_EQ(intersects(s, sphere), expected) << static_cast<int>(kind) << ", " << n;
      }
    }
  }
}

TEST(Law6TriangleSphere, GenericPairsAreDecidedWithoutExactArithmetic) {
  VolumeSource source(Numbers::Generic, 6);
  int touching = 0, apart = 0;
  for (int n = 0; n < 40000; ++n) {
    const double scale = n % 3 == 0 ? 1 : n % 3 == 1 ? 1e-20 : 1e40;
    Triangle t = source.triangle();
    t = {t.a * scale, t.b * scale, t.c * scale};
    const Sphere sphere = source.sphere();
    const Verdict verdict = triage(t, Sphere{sphere.centre * scale, sphere.radius * scale});
    ASSERT_NE(verdict, Verdict::Unsure) << n;
    (verdict == Verdict::Yes ? touching : apart)++;
  }
  EXPECT_GT(touching, 5000);
  EXPECT_GT(apart, 5000);
}

TEST(Law10TriangleSphere, BadValuesAreRefused) {
  const Triangle good{{2, 2, 2}, {3, 3, 3}, {2, 3, 2}};
  const Sphere unit{{0, 0, 0}, 1};
  for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (int i = 0; i < 9; ++i) {
      Triangle broken = good;
      Eigen::Vector3d* corner[] = {&broken.a, &broken.b, &broken.c};
      (*corner[i / 3])[i % 3] = bad;
      EXPECT_THROW(intersects(broken, unit), InputError) << i;
    }
    for (int i = 0; i < 4; ++i) {
      Sphere broken = unit;
      (i < 3 ? broken.centre[i] : broken.radius) = bad;
      EXPECT_THROW(intersects(good, broken), InputError) << i;
    }
  }
  EXPECT_THROW(intersects(good, Sphere{{2, 2, 2}, -1}), InputError);
  EXPECT_THROW(intersects(good, Sphere{{200, 2, 2}, -1}), InputError);
}

}  // namespace
}  // namespace graze

// Many random elements through all stages: what the triage is sure of against the exact stage, and
// its integers against expansions and long integers.

#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/shapes/random_source.h"

namespace graze::narrowphase {
namespace {

/// Some ulps away, or nowhere.
double nudged(double x, RandomSource& source) {
  const int steps = static_cast<int>(source.integer(-2, 2));
  for (int i = 0; i < std::abs(steps); ++i)
    x = std::nextafter(x, steps < 0 ? -HUGE_VAL : HUGE_VAL);
  return x;
}

Eigen::Vector3d nudged(const Eigen::Vector3d& p, RandomSource& source) {
  const double x = nudged(p.x(), source);
  const double y = nudged(p.y(), source);
  return {x, y, nudged(p.z(), source)};
}

constexpr int kKinds = 8;

Eigen::Vector3d point(int kind, RandomSource& source) {
  switch (kind) {
    case 0:
      return source.lattice_point(-2, 2);
    case 1:
      return source.vector(-1, 1) * std::ldexp(1.0, static_cast<int>(source.integer(-30, 0)));
    case 2:
      return source.vector(-1, 1) + Eigen::Vector3d(1e6, -1e3, 1e9);
    case 3:
      return source.vector(-1, 1).cwiseProduct(Eigen::Vector3d(1, 1e-9, 1e7));
    default:
      return source.vector(-1, 1);
  }
}

Eigen::Vector3d point_of(const Triangle& t, RandomSource& source) {
  const double s = source.uniform(0, 1);
  const double r = source.uniform(0, 1 - s);
  return t.a + (source.integer(0, 1) != 0 ? s : 0) * (t.b - t.a) + r * (t.c - t.a);
}

Triangle triangle(int kind, RandomSource& source) {
  const Eigen::Vector3d a = point(kind, source);
  const Eigen::Vector3d b = point(kind, source);
  return {a, b, point(kind, source)};
}

/// One of kind, or one that nearly touches `near` with a vertex or an edge, or lies in its plane.
Triangle second_triangle(int kind, const Triangle& near, RandomSource& source) {
  Triangle t = triangle(kind, source);
  if (kind >= 5) t.a = nudged(point_of(near, source), source);
  if (kind == 6) t.b = 2 * point_of(near, source) - t.a;
  if (kind == 7) {
    t.b = nudged(point_of(near, source), source);
    t.c = nudged(near.a + source.uniform(-1, 1) * (near.b - near.c), source);
  }
  return t;
}

bool is_wrong(Verdict verdict, bool truth) {
  return verdict == (truth ? Verdict::No : Verdict::Yes);
}

void hammer_pairs(int rounds, std::uint64_t seed) {
  RandomSource source(seed);
  int unsure = 0;
  for (int n = 0; n < rounds; ++n) {
    const int kind = n % kKinds;
    const Triangle a = triangle(kind, source);
    const Triangle b = second_triangle(kind, a, source);
    const bool truth = intersects_exactly(a, b);
    const Verdict verdict = triage(a, b);
    ASSERT_FALSE(is_wrong(verdict, truth)) << n;
    unsure += verdict == Verdict::Unsure;
    if (verdict == Verdict::Unsure || n % 64 < kKinds) {
      ASSERT_EQ(intersects_in_doubles(a, b), truth) << n;
    }
  }
  EXPECT_GT(unsure, rounds / 20);
  EXPECT_LT(unsure, rounds / 2);
}

void hammer_boxes(int rounds, std::uint64_t seed) {
  RandomSource source(seed);
  int unsure = 0;
  for (int n = 0; n < rounds; ++n) {
    const int kind = n % kKinds;
    const Triangle t = triangle(kind, source);
    const Eigen::Vector3d corner =
        kind >= 5 ? nudged(point_of(t, source), source) : point(kind, source);
    const Eigen::Vector3d other = point(kind, source);
    const Aabb box{corner.cwiseMin(other), corner.cwiseMax(other)};
    const Verdict verdict = triage(t, box);
    ASSERT_FALSE(is_wrong(verdict, intersects_exactly(t, box))) << n;
    unsure += verdict == Verdict::Unsure;
  }
  EXPECT_GT(unsure, rounds / 100);
  EXPECT_LT(unsure, rounds / 2);
}

TEST(Hammer, NoStageContradictsAnother) {
  hammer_pairs(400000, 1);
  hammer_boxes(400000, 2);
}

TEST(HammerSlow, NoStageContradictsAnother) {
  hammer_pairs(12000000, 3);
  hammer_boxes(12000000, 4);
}

}  // namespace
}  // namespace graze::narrowphase

#include <graze/engine/world/contacts/meshes/triangle_axes.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using narrowphase::Vec3;

struct Pair {
  Vec3 a[3];
  Vec3 b[3];
};

Triangle triangle_of(const Vec3 (&corner)[3]) {
  const auto point = [](const Vec3& v) { return Eigen::Vector3d(v.x, v.y, v.z); };
  return {point(corner[0]), point(corner[1]), point(corner[2])};
}

Vec3 point_in_box(double half, RandomSource& source) {
  return {source.uniform(-half, half), source.uniform(-half, half), source.uniform(-half, half)};
}

TEST(TriangleAxes, WhatIsSureIsTrueAndMostIsSure) {
  RandomSource source(1);
  int unsure = 0, apart = 0;
  constexpr int kPairs = 20000;
  for (int i = 0; i < kPairs; ++i) {
    Pair pair;
    const Vec3 offset = point_in_box(0.8, source);
    for (int k = 0; k < 3; ++k) {
      pair.a[k] = point_in_box(1, source);
      pair.b[k] = point_in_box(1, source) + offset;
    }
    const SureVerdict verdict = decide_by_axes(pair.a, pair.b);
    unsure += verdict == SureVerdict::Unsure, apart += verdict == SureVerdict::Apart;
    const bool is_hit = narrowphase::decide(triangle_of(pair.a), triangle_of(pair.b)).is_hit;
    if (verdict == SureVerdict::Unsure) continue;
    EXPECT_EQ(verdict == SureVerdict::Meet, is_hit) << i;
  }
  EXPECT_LT(unsure, 5);
  EXPECT_GT(apart, kPairs / 2);
  EXPECT_LT(apart, kPairs - kPairs / 10);
}

TEST(TriangleAxes, WhatTouchesOrNearlyDoesIsUnsure) {
  const Vec3 a[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const double gap : {0.0, 1e-13, -1e-13}) {
    const Vec3 b[3] = {{0.2, 0.2, gap}, {0.7, 0.3, 1}, {0.3, 0.8, 1.5}};
    EXPECT_EQ(decide_by_axes(a, b), SureVerdict::Unsure) << gap;
  }
}

TEST(TriangleAxes, TrianglesOfOnePlaneAreUnsure) {
  const Vec3 a[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Vec3 near[3] = {{0.1, 0.1, 0}, {1.1, 0.1, 0}, {0.1, 1.1, 0}};
  const Vec3 far[3] = {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  EXPECT_EQ(decide_by_axes(a, near), SureVerdict::Unsure);
  EXPECT_EQ(decide_by_axes(a, far), SureVerdict::Unsure);
}

TEST(TriangleAxes, ATriangleWithoutAreaIsNeverSaidToMeet) {
  const Vec3 a[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Vec3 line[3] = {{0.2, 0.2, -1}, {0.2, 0.2, 0.5}, {0.2, 0.2, 1}};
  EXPECT_NE(decide_by_axes(a, line), SureVerdict::Meet);
}

}  // namespace
}  // namespace graze

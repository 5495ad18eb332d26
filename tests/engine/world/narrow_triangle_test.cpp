// The point of a triangle that is nearest to another, of triangles as narrow as rounding.

#include <graze/narrowphase/convex/core/segments.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using narrowphase::Core;
using narrowphase::Vec3;

Vec3 vec(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// Of the point q of the triangle that is nearest to p this is 0: no corner c is ahead along the
/// way from q, (p - q) . (c - q) <= 0. What is off by d in the plane has at most d times its
/// length.
double excess(const Core& triangle, const Vec3& p, const Vec3& q) {
  double most = 0;
  for (const Vec3& corner : triangle.corner)
    most = std::max(most, dot(p - q, corner - q));
  return most;
}

/// How far q is from some point of the triangle: from the one with its weights along the longest
/// edge, the first, and across.
double outside(const Core& triangle, const Vec3& q) {
  const Vec3 edge = triangle.corner[1] - triangle.corner[0];
  const Vec3 beside = triangle.corner[2] - triangle.corner[0];
  const double at = dot(beside, edge) / dot(edge, edge);
  const Vec3 across = beside - edge * at;
  const double share = dot(q - triangle.corner[0], edge) / dot(edge, edge);
  const double room =
      std::min(share < at ? share / at : 1.0, share > at ? (1 - share) / (1 - at) : 1.0);
  const double up = dot(q - triangle.corner[0] - edge * share, across) / dot(across, across);
  const Vec3 within = triangle.corner[0] + edge * std::clamp(share, 0.0, 1.0) +
                      across * std::clamp(up, 0.0, std::max(room, 0.0));
  return length(q - within);
}

// By weights that are products of four lengths it once was anywhere along the triangle.
TEST(NearestOnTriangle, IsTheNearestOfNarrowOnes) {
  RandomSource source(105);
  int inside = 0;
  for (int n = 0; n < 40000; ++n) {
    const double width = std::pow(10.0, source.uniform(-12, 0));
    const Eigen::Vector3d along = source.vector(-1, 1).normalized();
    const Eigen::Vector3d across = along.cross(source.vector(-1, 1)).normalized();
    const Eigen::Vector3d up = along.cross(across);
    Core triangle;
    triangle.kind = narrowphase::CoreKind::Triangle;
    triangle.corner[0] = vec(-along);
    triangle.corner[1] = vec(along);
    triangle.corner[2] = vec(source.uniform(-0.9, 0.9) * along + width * across);
    const double height = std::pow(10.0, source.uniform(-3, 0));
    const Vec3 p = vec(source.uniform(-1.2, 1.2) * along + width * source.uniform(-1, 2) * across +
                       height * up);
    const Vec3 q = nearest_on_triangle(triangle, p);
    ASSERT_LE(excess(triangle, p, q), 0x1p-38) << n << " " << width;
    ASSERT_LE(outside(triangle, q), 4e-15) << n << " " << width;
    inside += std::abs(length(p - q) - height) < 1e-15;
  }
  EXPECT_GT(inside, 4000);
}

}  // namespace
}  // namespace graze

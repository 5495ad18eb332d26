// Law 15 where round bodies lie over the border of an open surface or straight above a ridge: the
// way out is that from the nearest point of the edge, though the way off the faces beside it is
// longer than at either end of what the edge faces.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using Eigen::Vector3d;

/// A flat sheet over [-1, 1]^2 of 4 by 4 squares.
Mesh flat_sheet() {
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (int i = 0; i < 25; ++i)
    vertices.push_back({0.5 * (i % 5 - 2), 0.5 * (i / 5 - 2), 0});
  for (std::uint32_t i = 0; i < 4; ++i) {
    for (std::uint32_t j = 0; j < 4; ++j) {
      const std::uint32_t at = 5 * i + j;
      triangles.push_back({at, at + 1, at + 6});
      triangles.push_back({at, at + 6, at + 5});
    }
  }
  return Mesh(vertices, triangles);
}

/// A roof whose ridge lies along x in the height 1.
Mesh roof(double half_width) {
  const std::vector<Vector3d> vertices = {{-2, -half_width, 0}, {2, -half_width, 0},
                                          {-2, 0, 1},           {2, 0, 1},
                                          {-2, half_width, 0},  {2, half_width, 0}};
  const std::vector<TriangleIndices> triangles = {{0, 1, 3}, {0, 3, 2}, {2, 3, 5}, {2, 5, 4}};
  return Mesh(vertices, triangles);
}

void expect_contact(const Manifold& found, const Vector3d& normal, double depth) {
  ASSERT_EQ(found.region_count(), 1u);
  double most = found[0].depth;
  for (const ShapeContact& contact : found) {
    most = std::max(most, contact.depth);
    ASSERT_LE((contact.normal - normal).norm(), 1e-3);
  }
  ASSERT_NEAR(most, depth, 1e-6 + 1e-3 * std::abs(depth));
}

TEST(Borders, Law15ABallOverABorderLeavesItsNearestPoint) {
  RandomSource source(1541);
  const Mesh sheet = flat_sheet();
  for (int n = 0; n < 400; ++n) {
    const double radius = source.uniform(0.2, 0.6);
    const double up = source.uniform(0.05, 1.5);  // from straight ahead of the border on
    const double out = n % 5 == 0 ? up : 2 * source.uniform(0, 1);
    const Vector3d away = Vector3d(n % 3 == 0 ? out : 0, n % 3 == 0 ? 0 : out, up).normalized();
    const Vector3d foot = n % 3 == 0 ? Vector3d(1, source.uniform(-0.9, 0.9), 0)
                                     : Vector3d(source.uniform(-0.9, 0.9), 1, 0);
    const double depth = radius * std::pow(10, source.uniform(-5, -1.2));
    Pose pose = Pose::Identity();
    pose.translation() = foot + (radius - depth) * away;
    SCOPED_TRACE(n);
    const Shape ball = Sphere{{0, 0, 0}, radius};
    expect_contact(find_contacts({sheet}, {ball, pose}), away, depth);
    pose.translation() += 2 * depth * away;
    const double margin = 0.2 * radius;
    expect_contact(find_contacts({sheet}, {ball, pose}, {.margin = margin}), away, -depth);
  }
}

TEST(Borders, Law15WhatIsRoundLiesOnARidge) {
  RandomSource source(1542);
  for (int n = 0; n < 200; ++n) {
    const Mesh ridge = roof(source.uniform(0.5, 8));
    const double radius = source.uniform(0.2, 0.6);
    const double depth = radius * std::pow(10, source.uniform(-5, -1.5));
    const Pose pose = tests::at(source.uniform(-1, 1), 0, 1 + radius - depth);
    SCOPED_TRACE(n);
    expect_contact(find_contacts({ridge}, {Sphere{{0, 0, 0}, radius}, pose}), {0, 0, 1}, depth);
    // A capsule that crosses the ridge.
    Pose across = pose;
    across.linear() =
        Eigen::AngleAxisd(0.5 * 3.141592653589793, Vector3d::UnitX()).toRotationMatrix();
    expect_contact(find_contacts({ridge}, {Capsule{radius, 0.1}, across}), {0, 0, 1}, depth);
  }
}

}  // namespace
}  // namespace graze

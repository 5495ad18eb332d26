// Shapes that touch a mesh by the tolerance of a hit alone: there is always a contact, however much
// smaller the shape is than the triangle and the tolerance.

#include <graze/engine/world/manifold.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

using Eigen::Vector3d;

/// The shape's lowest point along z at a point and a gap above it.
Pose above(const Shape& shape, const Vector3d& foot, double gap, RandomSource& source) {
  Pose pose = Pose::Identity();
  if (source.integer(0, 1) == 0) pose.linear() = tests::random_pose(1, source).linear();
  const double reach = tests::reach_along(shape, pose, Vector3d(0, 0, -1));
  pose.translation() = foot + Vector3d(0, 0, reach + gap);
  return pose;
}

TEST(WayOut, WhatTouchesByAToleranceAloneHasContacts) {
  RandomSource source(31);
  const Mesh box = tests::make_box({1, 1, 1});
  const Shape ground = box;
  int touching = 0;
  for (int n = 0; n < 4000; ++n) {
    const ShapeKind kind = tests::kOwnKinds[static_cast<std::size_t>(n % 7)];
    const double size = std::pow(10.0, source.uniform(-9, 0));
    const Shape shape = tests::random_shape(kind, size, source);
    // On a face, an edge or a corner.
    const auto place = [&] { return source.integer(0, 2) == 0 ? 1.0 : source.uniform(-1, 1); };
    const double gap = std::pow(10.0, source.uniform(-16, -10));
    const Pose pose = above(shape, Vector3d{place(), place(), 1}, gap, source);
    const bool is_hit = intersects({shape, pose}, {ground, Pose::Identity()});
    const Manifold found = find_contacts({shape, pose}, {ground, Pose::Identity()});
    ASSERT_EQ(found.empty(), !is_hit) << name_of(kind) << ' ' << size << ' ' << gap;
    touching += is_hit;
    for (const ShapeContact& contact : found) {
      EXPECT_GE(contact.depth, 0);
      EXPECT_NEAR((contact.point_a - contact.point_b).norm(), contact.depth, 1e-9);
      EXPECT_GT(contact.normal.z(), -1 - 1e-12);
      EXPECT_LT((contact.point - pose.translation()).norm(), 4 * size + 1e-9);
    }
    // With a margin they are near as distance() says.
    const Manifold near = find_contacts({shape, pose}, {ground, Pose::Identity()}, {.margin = gap});
    const ShapeDistance apart = distance({shape, pose}, {ground, Pose::Identity()});
    if (apart.status == PairStatus::Converged) {
      EXPECT_EQ(near.empty(), apart.distance > gap) << name_of(kind);
    }
  }
  EXPECT_GT(touching, 700);
}

}  // namespace
}  // namespace graze

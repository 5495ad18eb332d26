// Casts and motions beside a height field, and beside its mesh.

#include <graze/engine/print.h>
#include <graze/engine/world/shape_cast.h>
#include <graze/engine/world/shape_motion.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/engine/height_fields/random_fields.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::FieldTwins;
using tests::Ground;
using tests::random_pose;
using tests::random_shape;

bool is_exact(ShapeKind kind) {
  return kind == ShapeKind::Sphere || kind == ShapeKind::Box;
}

TEST(HeightFieldMotion, CastsMeetTheFieldWhenTheyMeetItsMesh) {
  RandomSource source(21);
  int hits = 0, starts = 0;
  for (int n = 0; n < 400; ++n) {
    const FieldTwins twins(
        tests::random_parts(static_cast<Ground>(n % tests::kGrounds), source).field());
    const Pose field_pose = n % 3 == 0 ? Pose::Identity() : random_pose(3, source);
    for (const ShapeKind kind : kShapeKinds) {
      if (kind >= ShapeKind::HeightField) continue;
      const Shape shape = random_shape(kind, 0.6, source);
      Pose pose = pose_near(twins, field_pose, source);
      Vector3d way = source.vector(-3, 3);
      if (n % 4 == 0) way = field_pose.linear() * Vector3d(0, 0, -2);
      if (n % 4 == 1) way *= 10;
      pose.translation() += field_pose.linear() * Vector3d(0, 0, source.uniform(0, 2));
      const auto found = cast({twins.field(), field_pose}, {shape, pose}, way);
      const auto wanted = cast({twins.mesh(), field_pose}, {shape, pose}, way);
      ASSERT_EQ(found.has_value(), wanted.has_value()) << n << name_of(kind);
      if (!found) continue;
      ++hits;
      starts += found->is_at_start;
      // To the tolerance of casts, in which triangles that others hide have a say or not.
      EXPECT_NEAR(found->time, wanted->time, 1e-8) << n << name_of(kind);
      EXPECT_EQ(found->is_at_start, wanted->is_at_start);
      if (is_exact(kind)) {
        EXPECT_EQ(*found, *wanted) << n << name_of(kind);
      }
      const auto swapped = cast({shape, pose}, {twins.field(), field_pose}, -way);
      ASSERT_TRUE(swapped.has_value());
      EXPECT_EQ(swapped->time, found->time);
      if (kind != ShapeKind::Mesh) {
        EXPECT_EQ(swapped->normal, -found->normal) << n << name_of(kind);
      }
    }
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(starts, 200);
  EXPECT_GT(hits - starts, 500);
}

TEST(HeightFieldMotion, ALongWayIsLookedAtPartByPart) {
  RandomSource source(22);
  tests::FieldParts parts;
  parts.columns = parts.rows = 600;
  for (std::uint32_t i = 0; i < 600 * 600; ++i)
    parts.heights.push_back(static_cast<float>(source.uniform(0, 1)));
  const FieldTwins twins(parts.field());
  int hits = 0;
  for (int n = 0; n < 30; ++n) {
    Pose pose = Pose::Identity();
    pose.translation() =
        Eigen::Vector3d{source.uniform(0, 600), source.uniform(0, 600), source.uniform(3, 60)};
    const Vector3d way =
        Vector3d{source.uniform(0, 600), source.uniform(0, 600), -1} - pose.translation();
    for (const Shape& shape : {Shape(Sphere{{0, 0, 0}, 0.8}), Shape(Capsule{0.4, 0.5})}) {
      Work work;
      const auto found = cast({twins.field()}, {shape, pose}, way, &work);
      const auto wanted = cast({twins.mesh()}, {shape, pose}, way);
      ASSERT_EQ(found.has_value(), wanted.has_value());
      if (!found) continue;
      ++hits;
      EXPECT_NEAR(found->time, wanted->time, 1e-8);
    }
  }
  EXPECT_GT(hits, 40);
}

TEST(HeightFieldMotion, FirstContactsAreThoseOfTheMesh) {
  RandomSource source(23);
  int hits = 0, free = 0;
  for (int n = 0; n < 100; ++n) {
    const FieldTwins twins(
        tests::random_parts(static_cast<Ground>(n % tests::kGrounds), source).field());
    const Pose field_pose = n % 3 == 0 ? Pose::Identity() : random_pose(3, source);
    for (const ShapeKind kind : kShapeKinds) {
      if (kind >= ShapeKind::HeightField) continue;
      const Shape shape = random_shape(kind, 0.5, source);
      Pose pose = pose_near(twins, field_pose, source);
      pose.translation() += field_pose.linear() * Vector3d(0, 0, source.uniform(0, 3));
      const RigidMotion motion(pose, {.centre = pose.translation(),
                                      .shift = source.vector(-3, 3),
                                      .axis = source.vector(-1, 1),
                                      .angle = n % 2 == 0 ? source.uniform(-2, 2) : 0});
      const bool turns = n % 5 == 0 && kind != ShapeKind::HalfSpace;
      const RigidMotion of_field(field_pose,
                                 {.centre = field_pose.translation(),
                                  .shift = n % 4 == 0 ? source.vector(-1, 1) : Vector3d(0, 0, 0),
                                  .axis = source.vector(-1, 1),
                                  .angle = turns ? source.uniform(-1, 1) : 0});
      const RigidContactSettings settings{.clearance = n % 7 == 0 ? 0.1 : 0, .tolerance = 1e-3};
      const RigidContact found =
          first_contact({twins.field(), of_field}, {shape, motion}, settings);
      EXPECT_EQ(found, first_contact({twins.mesh(), of_field}, {shape, motion}, settings))
          << n << name_of(kind);
      EXPECT_EQ(found, first_contact({shape, motion}, {twins.field(), of_field}, settings));
      EXPECT_EQ(is_free({twins.field(), of_field}, {shape, motion}, settings),
                found.status == RigidStatus::Free);
      hits += found.status == RigidStatus::Hit;
      free += found.status == RigidStatus::Free;
    }
  }
  EXPECT_GT(hits, 200);
  EXPECT_GT(free, 100);
}

TEST(HeightFieldMotion, RefusesWhatAMeshRefuses) {
  RandomSource source(24);
  const FieldTwins twins(tests::random_parts(Ground::Rough, source).field());
  const Shape ball = Sphere{{0, 0, 0}, 1};
  const Pose at = Pose::Identity();
  EXPECT_THROW(cast({twins.field()}, {ball, at}, {0, 0, 2e100}), PoseError);
  EXPECT_THROW(
      first_contact({twins.field(), RigidMotion(at)}, {ball, RigidMotion(at)}, {.clearance = -1}),
      InputError);
}

}  // namespace
}  // namespace graze

// Contacts with a height field beside those with its mesh, bit for bit.

#include <graze/engine/print.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/engine/height_fields/random_fields.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using tests::FieldTwins;
using tests::Ground;
using tests::random_pose;
using tests::random_shape;

struct Counts {
  int contacts = 0;
  int empty = 0;
};

/// Expects that contacts of a shape and the field are those with the mesh.
void expect_same(const FieldTwins& twins, const Pose& field_pose, const PlacedShapeView& shape,
                 const ManifoldSettings& settings, Counts& counts) {
  const Manifold found = find_contacts(shape, {twins.field(), field_pose}, settings);
  const Manifold wanted =
      twins.numbered(find_contacts(shape, {twins.mesh(), field_pose}, settings), false);
  EXPECT_EQ(found, wanted) << name_of(shape.shape.kind()) << " " << found.size() << " "
                           << wanted.size();
  counts.contacts += static_cast<int>(found.size());
  counts.empty += found.empty();
  const ManifoldSettings mirrored{.margin = settings.margin, .sides_a = settings.sides_b};
  const Manifold other = find_contacts({twins.field(), field_pose}, shape, mirrored);
  EXPECT_EQ(other,
            twins.numbered(find_contacts({twins.mesh(), field_pose}, shape, mirrored), true));
}

TEST(HeightFieldContacts, AreThoseOfTheMesh) {
  RandomSource source(11);
  Counts counts;
  for (int n = 0; n < 400; ++n) {
    const FieldTwins twins(
        tests::random_parts(static_cast<Ground>(n % tests::kGrounds), source).field());
    const Pose field_pose = n % 3 == 0 ? Pose::Identity() : random_pose(3, source);
    for (const ShapeKind kind : kShapeKinds) {
      if (kind >= ShapeKind::HalfSpace) continue;
      const Shape shape = random_shape(kind, source.integer(0, 3) == 0 ? 3 : 0.7, source);
      const Pose pose = pose_near(twins, field_pose, source);
      expect_same(twins, field_pose, {shape, pose}, {}, counts);
    }
  }
  EXPECT_GT(counts.contacts, 2000);
  EXPECT_GT(counts.empty, 200);
}

TEST(HeightFieldContacts, WithAMarginAreThoseOfTheMesh) {
  RandomSource source(12);
  Counts counts;
  for (int n = 0; n < 300; ++n) {
    const FieldTwins twins(
        tests::random_parts(static_cast<Ground>(n % tests::kGrounds), source).field());
    const Pose field_pose = n % 3 == 0 ? Pose::Identity() : random_pose(3, source);
    for (const ShapeKind kind : kShapeKinds) {
      if (kind >= ShapeKind::HalfSpace) continue;
      const Shape shape = random_shape(kind, 0.7, source);
      const Pose pose = pose_near(twins, field_pose, source);
      expect_same(twins, field_pose, {shape, pose}, {.margin = source.uniform(0, 0.5)}, counts);
    }
  }
  EXPECT_GT(counts.contacts, 2000);
}

TEST(HeightFieldContacts, OneSidedAreThoseOfTheMesh) {
  RandomSource source(13);
  Counts counts;
  for (int n = 0; n < 200; ++n) {
    const FieldTwins twins(
        tests::random_parts(static_cast<Ground>(n % tests::kGrounds), source).field());
    const Pose field_pose = n % 3 == 0 ? Pose::Identity() : random_pose(3, source);
    for (const ShapeKind kind : kShapeKinds) {
      if (kind >= ShapeKind::HalfSpace) continue;
      const Shape shape = random_shape(kind, 0.5, source);
      Pose pose = pose_near(twins, field_pose, source);
      pose.translation() -= field_pose.linear() * Eigen::Vector3d(0, 0, source.uniform(0, 1));
      const MeshSides sides = MeshSides::one_sided(source.uniform(0.1, 1.5));
      expect_same(twins, field_pose, {shape, pose}, {.sides_b = sides}, counts);
    }
  }
  EXPECT_GT(counts.contacts, 1000);
}

TEST(HeightFieldContacts, OfSolidsThereAreNone) {
  RandomSource source(14);
  const Shape field = tests::random_parts(Ground::Rough, source).field();
  const Shape ball = Sphere{{0, 0, 0}, 1};
  EXPECT_THROW(find_contacts({ball}, {field}, {.sides_b = MeshSides::solid()}), MeshError);
}

TEST(HeightFieldContacts, WithHalfSpacesAndMeshesAreThoseOfTheMesh) {
  RandomSource source(15);
  int found_contacts = 0;
  for (int n = 0; n < 150; ++n) {
    const FieldTwins twins(
        tests::random_parts(static_cast<Ground>(n % tests::kGrounds), source).field());
    const Pose field_pose = n % 3 == 0 ? Pose::Identity() : random_pose(3, source);
    Counts counts;
    const Shape below = random_shape(ShapeKind::HalfSpace, 1, source);
    expect_same(twins, field_pose, {below, pose_near(twins, field_pose, source)}, {}, counts);
    const Shape torus = random_shape(ShapeKind::Mesh, 1, source);
    const Pose pose = pose_near(twins, field_pose, source);
    const Manifold manifold = find_contacts({torus, pose}, {twins.field(), field_pose});
    const Manifold wanted = find_contacts({torus, pose}, {twins.mesh(), field_pose});
    EXPECT_EQ(manifold.empty(), wanted.empty());
    // Which regions there are, of two meshes, depends on the order in which trees tell of pairs.
    if (!manifold.empty()) {
      EXPECT_NEAR(manifold[0].depth, wanted[0].depth, 0.05 * wanted[0].depth) << n;
    }
    found_contacts += counts.contacts + static_cast<int>(manifold.size());
  }
  EXPECT_GT(found_contacts, 300);
}

TEST(HeightFieldContacts, ABoxOnFlatGroundHasFourOfItsCorners) {
  tests::FieldParts parts;
  parts.columns = parts.rows = 200;
  parts.heights.assign(std::size_t{200} * 200, 2);
  const Shape field = parts.field();
  const Shape box = Box{{3, 3, 3}};
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Vector3d{100.25, 100.25, 4.9};
  const Manifold found = find_contacts({box, pose}, {field});
  ASSERT_EQ(found.size(), 4u);
  for (const ShapeContact& contact : found) {
    EXPECT_EQ(contact.normal, Eigen::Vector3d(0, 0, -1));
    EXPECT_NEAR(contact.depth, 0.1, 1e-12);
    EXPECT_NEAR(std::abs(contact.point.x() - 100.25), 3, 1e-12);
  }
}

}  // namespace
}  // namespace graze

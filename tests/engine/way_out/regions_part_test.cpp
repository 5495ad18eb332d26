// Law 15: moved along its way out by a region's greatest depth a shape is apart from the triangles
// that it touched, by less it is not, where what is deepest lies beside these triangles: past a rim
// by a hair, or within the mesh beyond them. Whether single triangles meet the shape is the truth.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "tests/engine/way_out/tessellated.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;

/// The triangles of a mesh, which rests, that a shape touches.
std::optional<Shape> touched_part(const Mesh& mesh, const Shape& shape, const Pose& pose) {
  std::vector<TriangleIndices> touched;
  for (const TriangleIndices& triangle : mesh.triangles()) {
    const std::vector<TriangleIndices> alone = {triangle};
    if (intersects({Mesh(mesh.vertices(), alone)}, {shape, pose})) touched.push_back(triangle);
  }
  if (touched.empty()) return std::nullopt;
  return Shape(Mesh(mesh.vertices(), touched));
}

/// Returns whether the pair has one region.
bool expect_parted(const Mesh& mesh, const Shape& shape, const Pose& pose, double size) {
  const Manifold found = find_contacts({mesh}, {shape, pose});
  if (found.region_count() != 1) return false;
  double depth = 0;
  for (const ShapeContact& contact : found)
    depth = std::max(depth, contact.depth);
  const std::optional<Shape> touched = touched_part(mesh, shape, pose);
  if (!touched) return false;
  const auto meet_after = [&](double way) {
    Pose moved = pose;
    moved.translation() += way * found[0].normal;
    return intersects({*touched}, {shape, moved});
  };
  EXPECT_FALSE(meet_after(1.001 * depth + 1e-6 * size)) << depth;
  EXPECT_TRUE(depth < 1e-6 * size || meet_after(0.95 * depth - 1e-6 * size)) << depth;
  return true;
}

/// The last point of a placed shape in a direction, near which its surface is curved.
Vector3d last_point(const Shape& shape, const Pose& pose, const Vector3d& way) {
  constexpr double kStep = 1e-6;
  Vector3d point;
  for (int k = 0; k < 3; ++k) {
    const Vector3d ahead = way + kStep * Vector3d::Unit(k),
                   behind = way - kStep * Vector3d::Unit(k);
    // The reach is as many times longer as the direction is.
    point[k] = (ahead.norm() * tests::reach_along(shape, pose, ahead.normalized()) -
                behind.norm() * tests::reach_along(shape, pose, behind.normalized())) /
               (2 * kStep);
  }
  return point;
}

/// Lays a shape on the upper side of a box, its lowest point past an edge by next to nothing.
TEST(WayOut, Law15WhatIsDeepestPastARimParts) {
  RandomSource source(1551);
  int asked = 0;
  for (int n = 0; n < 600; ++n) {
    // Of large boxes gaps are known less well than the body is small.
    const double times = n % 2 == 0 ? 1 : 200;
    const Vector3d half{times * source.uniform(0.3, 1), times * source.uniform(0.3, 1),
                        times * source.uniform(0.3, 1)};
    const Mesh box = tests::tessellated_box(half, 1 + n % 5);
    const ShapeKind kinds[] = {ShapeKind::Sphere, ShapeKind::Capsule, ShapeKind::Ellipsoid,
                               ShapeKind::Cylinder, ShapeKind::Cone};
    const Shape shape = tests::random_shape(kinds[n % 5], 0.5, source);
    Pose pose = tests::random_pose(0, source);
    const Vector3d down(0, 0, -1);
    const Vector3d lowest = last_point(shape, pose, down);
    const double depth = std::pow(10, source.uniform(-5, -2.5));
    const Vector3d foot{half.x() + depth * source.uniform(0, 1), half.y() * source.uniform(-1, 1),
                        half.z() - depth};
    pose.translation() += foot - lowest;
    SCOPED_TRACE((std::ostringstream() << n << " " << name_of(shape.kind())).str());
    asked += expect_parted(box, shape, pose, 0.5);
  }
  EXPECT_GT(asked, 500);
}

/// What has sunk through the triangles of a coarse ball up to a twentieth of its size may be
/// deepest where it touches none of them.
TEST(WayOut, Law15WhatIsDeepestBesideItsTrianglesParts) {
  RandomSource source(1552);
  int asked = 0;
  for (int n = 0; n < 1500; ++n) {
    const double radius = source.uniform(0.3, 1);
    const Mesh ball = tests::make_sphere(radius, 3 + n % 4, 6 + 2 * (n % 4));
    const ShapeKind kinds[] = {ShapeKind::Box, ShapeKind::Cylinder, ShapeKind::Cone,
                               ShapeKind::ConvexHull};
    const Shape shape = tests::random_shape(kinds[n % 4], 0.5, source);
    Pose pose = tests::random_pose(0, source);
    const double depth = radius * std::pow(10, source.uniform(-3, -1));
    const double beside = 0.5 * radius;
    pose.translation() =
        Vector3d{source.uniform(-beside, beside), source.uniform(-beside, beside), 0};
    pose.translation().z() = 0.9 * radius - depth + tests::reach_of(shape, pose, {0, 0, -1});
    SCOPED_TRACE((std::ostringstream() << n << " " << name_of(shape.kind())).str());
    asked += expect_parted(ball, shape, pose, radius);
  }
  EXPECT_GT(asked, 500);
}

}  // namespace
}  // namespace graze

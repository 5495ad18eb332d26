// Planes beside meshes and height fields: triangle by triangle, meshes in pieces among them.

#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/height_field.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tests/engine/height_fields/random_fields.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::at;
using tests::random_pose;

/// Of all triangles alone: the least distance, and how far the mesh has to go to either side.
struct Brute {
  double distance = std::numeric_limits<double>::infinity();
  double low = std::numeric_limits<double>::infinity(), high = -low;

  Brute(const Mesh& mesh, const Pose& pose, const Plane& plane, const Pose& of_plane) {
    const Vector3d normal = of_plane.linear() * plane.normal;
    const double offset = plane.offset + normal.dot(of_plane.translation());
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
      const Triangle t = place(pose, mesh.triangle(i));
      const double heights[3] = {normal.dot(t.a) - offset, normal.dot(t.b) - offset,
                                 normal.dot(t.c) - offset};
      const auto [least, most] = std::minmax_element(heights, heights + 3);
      distance = std::min(distance, std::max({*least, -*most, 0.0}));
      low = std::min(low, *least);
      high = std::max(high, *most);
    }
  }
};

/// Two boxes side by side along z, of which nothing lies between -1 and 1.
Mesh two_pieces() {
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (const double height : {2.0, -3.0}) {
    const Mesh box = tests::make_box({1, 1, 1});
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const Vector3d& v : box.vertices())
      vertices.push_back(v + Vector3d(0, 0, height));
    for (const TriangleIndices& t : box.triangles())
      triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return Mesh(vertices, triangles);
}

TEST(PlanesAndMeshes, AreThoseOfAllTriangles) {
  RandomSource source(3);
  int hits = 0, divided = 0, apart = 0;
  for (int n = 0; n < 1200 && !HasFailure(); ++n) {
    SCOPED_TRACE(n);
    const Mesh mesh =
        n % 3 == 0 ? two_pieces()
                   : tests::random_soup({.count = static_cast<std::size_t>(1 + n % 9), .size = 0.3},
                                        source);
    const Shape as_shape = tests::random_shape(ShapeKind::Plane, 1, source);
    const Pose pose = n % 3 == 0 ? at(0, 0, source.uniform(-1, 1)) : random_pose(0.5, source);
    const Pose of_plane = n % 3 == 0 ? Pose::Identity() : random_pose(0.5, source);
    const Shape wall = n % 3 == 0 ? Shape(Plane{{0.1, 0, 1}, 0}) : as_shape;
    const Brute brute(mesh, pose, *wall.as<Plane>(), of_plane);
    const Shape shape = mesh;
    const PlacedShapeView other{wall, of_plane}, own{shape, pose};
    ASSERT_EQ(intersects(own, other), brute.distance == 0);
    ASSERT_EQ(intersects(other, own), brute.distance == 0);
    const ShapeDistance found = distance(own, other);
    ASSERT_NEAR(found.distance, brute.distance, 1e-14);
    EXPECT_LE(found.lower_bound, brute.distance + 1e-15);
    EXPECT_NEAR((found.point_a - found.point_b).norm(), brute.distance, 1e-14);
    const Manifold contacts = find_contacts(own, other);
    if (brute.distance > 0) {
      EXPECT_TRUE(contacts.empty());
      const bool is_divided = brute.low < 0 && brute.high > 0;
      divided += is_divided, apart += !is_divided;
      const Manifold near = find_contacts(own, other, {.margin = 2 * brute.distance});
      ASSERT_FALSE(near.empty());
      EXPECT_NEAR(near[0].depth, -brute.distance, 1e-13);
      continue;
    }
    ++hits;
    const Shape point = Sphere{found.point_a, 1e-14};
    EXPECT_TRUE(intersects(point, other));
    EXPECT_LT(distance(point, own).distance, 1e-14);
    ASSERT_FALSE(contacts.empty());
    EXPECT_NEAR(contacts[0].depth, std::min(-brute.low, brute.high), 1e-14);
  }
  EXPECT_GT(hits, 200);
  EXPECT_GT(divided, 200);
  EXPECT_GT(apart, 30);
}

TEST(PlanesAndMeshes, PiecesOnBothSidesAreNearFromBoth) {
  const Shape pieces = two_pieces();
  const Shape floor = Plane{{0, 0, 1}, 0};
  EXPECT_FALSE(intersects(pieces, floor));
  const ShapeDistance found = distance(pieces, floor);
  EXPECT_EQ(found.distance, 1);
  EXPECT_EQ(found.point_a.z(), 1);
  EXPECT_EQ(found.normal, Vector3d(0, 0, -1));
  const Manifold one_side = find_contacts(pieces, floor, {.margin = 1.5});
  EXPECT_EQ(one_side.region_count(), 1u);
  const Manifold both = find_contacts(pieces, floor, {.margin = 2.5});
  ASSERT_EQ(both.region_count(), 2u);
  EXPECT_EQ(both[0].depth, -1);
  EXPECT_EQ(both[0].normal, Vector3d(0, 0, -1));
  EXPECT_EQ(both.region(1)[0].depth, -2);
  EXPECT_EQ(both.region(1)[0].normal, Vector3d(0, 0, 1));
  for (const ShapeContact& contact : both.region(1))
    EXPECT_GE(contact.feature.a, 8u);  // vertices keep their numbers
  EXPECT_EQ(distance({pieces, at(0, 0, 0.75)}, floor).normal, Vector3d(0, 0, 1));
}

TEST(PlanesAndMeshes, AFieldIsItsMeshWithHolesToo) {
  RandomSource source(5);
  int hits = 0;
  for (int n = 0; n < 400 && !HasFailure(); ++n) {
    SCOPED_TRACE(n);
    tests::FieldParts parts =
        tests::random_parts(static_cast<tests::Ground>(n % tests::kGrounds), source);
    if (n % 2 == 0) parts.holes.clear();
    const tests::FieldTwins twins(parts.field());
    const Shape plane = tests::random_shape(ShapeKind::Plane, 4, source);
    const Pose pose = random_pose(2, source);
    const PlacedShapeView wall{plane, pose};
    const bool is_hit = intersects(twins.field(), wall);
    EXPECT_EQ(is_hit, intersects(twins.mesh(), wall));
    const ShapeDistance found = distance(twins.field(), wall);
    EXPECT_EQ(found.distance, distance(twins.mesh(), wall).distance);
    const Manifold contacts = find_contacts(twins.field(), wall);
    EXPECT_EQ(contacts.empty(), !is_hit);
    hits += is_hit;
    if (!is_hit) continue;
    const Shape point = Sphere{found.point_a, 1e-12};
    EXPECT_TRUE(intersects(point, wall));
    EXPECT_TRUE(intersects(point, twins.mesh()));
  }
  EXPECT_GT(hits, 50);
}

TEST(PlanesAndMeshes, AFieldInTwoPiecesIsBesideThePlaneBetweenThem) {
  const std::vector<float> heights = {-1, -1, 0, 1, 1, -1, -1, 0, 1, 1};
  const std::vector<std::uint8_t> holes = {0, 1, 1, 0};
  const Shape field = HeightField(5, 2, heights, {.holes = holes});
  const Shape plane = Plane{{0, 0, 1}, 0.25};
  EXPECT_FALSE(intersects({field}, {plane}));
  EXPECT_EQ(distance({field}, {plane}).distance, 0.75);
  EXPECT_TRUE(find_contacts({field}, {plane}).empty());
  EXPECT_EQ(find_contacts({field}, {plane}, {.margin = 1.5}).region_count(), 2u);
  World world;
  world.add({field}, {.kind = BodyKind::Static});
  const BodyId moving = world.add({plane});
  EXPECT_TRUE(world.update().contacts.empty());
  world.move(moving, at(0, 0, 1));
  EXPECT_EQ(world.update().begun.size(), 0u);
  world.move(moving, at(0, 0, 0.75));
  EXPECT_EQ(world.update().begun.size(), 1u);
}

}  // namespace
}  // namespace graze

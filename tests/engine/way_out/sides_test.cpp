// Law 15 where a mesh is a solid, or has one side: what is behind its surface without touching it.

#include <graze/engine/world/height_field.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <vector>

#include "tests/engine/way_out/tessellated.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;

constexpr MeshSides kSolid = MeshSides::solid();

std::vector<Shape> small_bodies(int n, RandomSource& source) {
  std::vector<Shape> all;
  for (const ShapeKind kind :
       {ShapeKind::Sphere, ShapeKind::Box, ShapeKind::Capsule, ShapeKind::Cylinder, ShapeKind::Cone,
        ShapeKind::Ellipsoid, ShapeKind::ConvexHull})
    all.push_back(tests::random_shape(kind, 0.2, source));
  for (const auto kind : tests::kConvexMeshKinds)
    all.push_back(tests::convex_mesh(kind, n % 3, source));
  return all;
}

/// The least translation out of a box around the origin, through the nearest of its faces.
double way_out_of(const Vector3d& half, const Shape& body, const Pose& pose) {
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Vector3d out = sign * Vector3d::Unit(axis);
      least = std::min(least, half[axis] + tests::reach_of(body, pose, -out));
    }
  }
  return least;
}

TEST(Sides, Law15WhatIsInASolidLeavesByTheNearestWay) {
  RandomSource source(1511);
  int asked = 0, over_faces = 0;
  for (int n = 0; n < 30; ++n) {
    const Vector3d half{source.uniform(0.9, 1.6), source.uniform(0.9, 1.6),
                        source.uniform(0.9, 1.6)};
    const Shape solid = tests::tessellated_box(half, 1 + n % 6);
    for (const Shape& body : small_bodies(n, source)) {
      Pose pose = tests::random_pose(0, source);
      pose.translation() =
          0.4 * Vector3d{source.uniform(-1, 1), source.uniform(-1, 1), source.uniform(-1, 1)};
      if (intersects({body, pose}, {solid, Pose::Identity()})) continue;
      ++asked;
      const double depth = way_out_of(half, body, pose);
      const Manifold found =
          find_contacts({body, pose}, {solid, Pose::Identity()}, {.sides_b = kSolid});
      SCOPED_TRACE((std::ostringstream() << n << " " << name_of(body.kind())).str());
      ASSERT_EQ(found.region_count(), 1u);
      ASSERT_LE(found[0].depth, depth + 1e-6);
      // From the body to the solid: against the way out, which may lead over an edge.
      const Vector3d out = -found[0].normal;
      ASSERT_NEAR(found[0].depth, half.dot(out.cwiseAbs()) + tests::reach_of(body, pose, -out),
                  1e-6);
      over_faces += out.cwiseAbs().maxCoeff() > 1 - 1e-9;
      for (const ShapeContact& contact : found) {
        ASSERT_NEAR(contact.point_b.dot(out), half.dot(out.cwiseAbs()), 1e-6);
        ASSERT_LE((contact.point_a - contact.point_b - contact.depth * contact.normal).norm(),
                  1e-5);
      }
      Pose moved = pose;
      moved.translation() -= 1.00001 * found[0].depth * found[0].normal;
      ASSERT_TRUE(
          find_contacts({body, moved}, {solid, Pose::Identity()}, {.sides_b = kSolid}).empty());
      const Manifold mirrored =
          find_contacts({solid, Pose::Identity()}, {body, pose}, {.sides_a = kSolid});
      ASSERT_EQ(mirrored.size(), found.size());
      ASSERT_EQ(mirrored[0].normal, -found[0].normal);
      ASSERT_EQ(mirrored[0].point_a, found[0].point_b);
      ASSERT_TRUE(find_contacts({body, pose}, {solid, Pose::Identity()}).empty());
    }
  }
  EXPECT_GT(asked, 200);
  EXPECT_GT(over_faces, asked * 9 / 10);
}

/// In one arm of an L the way out is that arm's, however near the planes of the other's faces are.
TEST(Sides, Law15AWayOutIsThroughTheFaceItself) {
  RandomSource source(1512);
  std::vector<tests::Cube> cubes;
  for (int i = 0; i < 4; ++i)
    cubes.push_back({i, 0, 0});
  for (int k = 1; k < 4; ++k)
    cubes.push_back({0, 0, k});
  for (int n = 0; n < 40; ++n) {
    const Shape solid = tests::surface_of_cubes(cubes, 1, 1 << (n % 3), source);
    const double x = source.uniform(2.2, 3), z = source.uniform(0.35, 0.65), radius = 0.1;
    const Manifold found = find_contacts({Sphere{{0, 0, 0}, radius}, tests::at(x, 0.45, z)},
                                         {solid}, {.sides_b = kSolid});
    ASSERT_EQ(found.size(), 1u) << n;
    const double expected = std::min({0.45, z, 1 - z, 4 - x}) + radius;
    ASSERT_NEAR(found[0].depth, expected, 1e-9) << n;
  }
}

/// Beside the plane of a pit's wall, but below the pit, the wall is no way out.
TEST(Sides, Law15APlaneWithoutItsFaceIsNoWayOut) {
  RandomSource source(1518);
  std::vector<tests::Cube> cubes;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      for (int k = 0; k < 4; ++k) {
        const bool is_pit = i == 2 && j > 0 && j < 3 && k == 3;
        if (!is_pit) cubes.push_back({i, j, k});
      }
    }
  }
  for (int n = 0; n < 20; ++n) {
    const Shape solid = tests::surface_of_cubes(cubes, 1, 1 << (n % 3), source);
    const double x = source.uniform(1.8, 1.95), z = source.uniform(1.5, 1.7);
    const Manifold found =
        find_contacts({Sphere{{0, 0, 0}, 0.1}, tests::at(x, 2, z)}, {solid}, {.sides_b = kSolid});
    ASSERT_EQ(found.size(), 1u) << n;
    ASSERT_NEAR(found[0].depth, z + 0.1, 1e-9) << n;
  }
}

TEST(Sides, Law15WhatIsBehindASurfaceLeavesInFront) {
  RandomSource source(1513);
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (int i = 0; i <= 8; ++i) {
    for (int j = 0; j <= 8; ++j)
      vertices.push_back({i - 4.0, j - 4.0, 0});
  }
  for (std::uint32_t i = 0; i < 8; ++i) {
    for (std::uint32_t j = 0; j < 8; ++j) {
      const std::uint32_t a = i * 9 + j;
      triangles.push_back({a, a + 9, a + 10});
      triangles.push_back({a, a + 10, a + 1});
    }
  }
  const Shape floor = Mesh(vertices, std::span<const TriangleIndices>(triangles));
  const MeshSides sides = MeshSides::one_sided(0.5);
  for (int n = 0; n < 60; ++n) {
    for (const Shape& body : small_bodies(n, source)) {
      Pose pose = tests::random_pose(0, source);
      const double below = source.uniform(0.01, 0.8);
      pose.translation() = Vector3d{source.uniform(-1, 1), source.uniform(-1, 1), 0};
      pose.translation().z() = -below - tests::reach_of(body, pose, {0, 0, 1});
      const Manifold found = find_contacts({body, pose}, {floor}, {.sides_b = sides});
      SCOPED_TRACE(
          (std::ostringstream() << n << " " << name_of(body.kind()) << " " << below).str());
      ASSERT_EQ(found.empty(), below > 0.5);
      Pose above = pose;
      above.translation().z() =
          below + tests::reach_of(body, pose, {0, 0, -1}) + pose.translation().z();
      ASSERT_TRUE(find_contacts({body, above}, {floor}, {.sides_b = sides}).empty());
      if (found.empty()) continue;
      const double depth = tests::reach_of(body, pose, {0, 0, -1});
      ASSERT_NEAR(found[0].depth, depth, 1e-6);
      ASSERT_LE((found[0].normal - Vector3d(0, 0, -1)).norm(), 1e-9);
    }
  }
}

TEST(Sides, AWorldKnowsThem) {
  World world;
  const Shape solid = tests::tessellated_box({2, 2, 2}, 4);
  const BodyId rock = world.add({solid}, {.kind = BodyKind::Static, .sides = kSolid});
  const BodyId ball = world.add({Sphere{{0, 0, 0}, 0.5}, tests::at(0, 0, 4)});
  EXPECT_EQ(world.sides(rock), kSolid);
  EXPECT_TRUE(world.update().begun.empty());
  world.move(ball, tests::at(0.1, 0.2, 1));
  const WorldUpdate inside = world.update();
  ASSERT_EQ(inside.begun.size(), 1u);
  ASSERT_EQ(inside.contacts.size(), 1u);
  EXPECT_NEAR(inside.contacts[0].manifold[0].depth, 1.5, 1e-9);
  EXPECT_EQ(world.contacts().size(), 1u);
  world.move(ball, tests::at(0.1, 0.2, 1.1));
  EXPECT_EQ(world.update().moved.size(), 1u);
  world.move(ball, tests::at(0, 0, 4));
  EXPECT_EQ(world.update().ended.size(), 1u);
  EXPECT_TRUE(world.find_touching({Sphere{{0, 0, 0}, 0.5}}).empty()) << "queries see surfaces";
}

/// Bodies that fall past a surface are told of while they are as near as its thickness, whatever is
/// left out.
TEST(Sides, AWorldLooksAsDeepAsTheThickness) {
  const Mesh slab = tests::tessellated_box({3, 3, 0.01}, 2);
  for (const bool skips : {true, false}) {
    World world({.skip_apart = skips});
    std::vector<TriangleIndices> top;
    for (const TriangleIndices& triangle : slab.triangles()) {
      if (std::all_of(triangle.begin(), triangle.end(),
                      [&](std::uint32_t vertex) { return slab.vertices()[vertex].z() > 0; }))
        top.push_back(triangle);
    }
    world.add({Mesh(slab.vertices(), std::span<const TriangleIndices>(top))},
              {.kind = BodyKind::Static, .sides = MeshSides::one_sided(1)});
    const BodyId ball = world.add({Cylinder{0.2, 0.2}, tests::at(0, 0, -5)});
    for (int step = 0; step < 100; ++step) {
      const double z = -5 + 0.07 * step;
      world.move(ball, tests::at(0, 0, z));
      world.update();
      const bool is_expected = z + 0.2 >= 0.01 - 1 && z - 0.2 <= 0.01;
      ASSERT_EQ(world.pairs().size(), is_expected ? 1u : 0u) << skips << " " << z;
    }
  }
}

/// A half-space, which no finite way leads out, is behind nothing.
TEST(Sides, HalfSpacesOnlyTouch) {
  const Mesh box = tests::tessellated_box({1, 1, 1}, 1);
  const HalfSpace below{{0, 0, 1}, -1.5};
  for (const MeshSides& sides : {kSolid, MeshSides::one_sided(9)}) {
    EXPECT_TRUE(find_contacts({below}, {Shape(box)}, {.sides_b = sides}).empty());
    EXPECT_TRUE(find_contacts({Shape(box)}, {below}, {.sides_a = sides}).empty());
  }
}

/// A terrain over [-1, 1]^2 whose corners are up to a fifth high or deep.
Mesh uneven_sheet(RandomSource& source) {
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (int i = 0; i < 25; ++i)
    vertices.push_back({0.5 * (i % 5 - 2), 0.5 * (i / 5 - 2), source.uniform(-0.2, 0.2)});
  for (std::uint32_t y = 0; y < 4; ++y) {
    for (std::uint32_t x = 0; x < 4; ++x) {
      const std::uint32_t at = 5 * y + x;
      triangles.push_back({at, at + 1, at + 5});
      triangles.push_back({at + 1, at + 6, at + 5});
    }
  }
  return Mesh(vertices, triangles);
}

// Under its border the least way may lead out sideways, shorter than the gap to the sheet.
TEST(Sides, WhatTouchesFromBehindHasContacts) {
  RandomSource source(1519);
  int enclosed = 0;
  for (int n = 0; n < 400; ++n) {
    const Mesh sheet = uneven_sheet(source);
    const MeshSides sides = MeshSides::one_sided(0.2);
    const Shape box = Box{{0.75, 0.375, 0.125}};
    const Pose pose = tests::at({1.75 - std::pow(10, source.uniform(-4, -0.5)),
                                 source.uniform(-0.5, 0.5), source.uniform(-0.4, -0.2)});
    World world({.threads = 1});
    world.add({box, pose});
    world.add({sheet}, {.kind = BodyKind::Static, .sides = sides});
    const WorldUpdate update = world.update();
    for (const BodyContact& each : update.contacts)
      EXPECT_FALSE(each.manifold.empty()) << n;
    const bool is_hit = intersects({box, pose}, {sheet});
    enclosed += !world.pairs().empty() && !is_hit;
    EXPECT_EQ(find_contacts({box, pose}, {sheet}, {.sides_b = sides}).empty(),
              world.pairs().empty());
  }
  EXPECT_GT(enclosed, 50);
}

TEST(Sides, ACapsuleWithoutLengthIsABall) {
  const Shape sheet = HeightField(9, 9, std::vector<float>(81, 0.f));
  const Shape solid = tests::tessellated_box({2, 2, 2}, 2);
  for (const Vector3d& axis : {Vector3d(0, 0, 1), Vector3d(1, 0, 0), Vector3d(1, 2, 3)}) {
    for (const double gap : {0.0, 0.125, 0.25}) {
      Pose pose = tests::at(4.25, 4.125, -0.5 - gap);
      pose.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d(0, 0, 1), axis).matrix();
      Pose inside = pose;
      inside.translation() = Vector3d(0.1, 0.2, 1.25);
      const MeshSides one = MeshSides::one_sided(1);
      for (const Shape& body : {Shape(Capsule{0.5, 0}), Shape(Sphere{{0, 0, 0}, 0.5})}) {
        const Manifold found = find_contacts({sheet}, {body, pose}, {.sides_a = one});
        ASSERT_FALSE(found.empty());
        EXPECT_NEAR(found[0].depth, 1 + gap, 1e-9);
        const Manifold out = find_contacts({solid}, {body, inside}, {.sides_a = kSolid});
        ASSERT_FALSE(out.empty());
        EXPECT_NEAR(out[0].depth, 1.25, 1e-9);
      }
    }
  }
}

/// A cube, its own vertices moved, and a vertex more that no triangle has.
Mesh cube_with(const Vector3d& stray, const Vector3d& offset) {
  const Mesh cube = tests::tessellated_box({0.25, 0.25, 0.25}, 1);
  std::vector<Vector3d> vertices;
  for (const Vector3d& vertex : cube.vertices())
    vertices.push_back(vertex + offset);
  vertices.push_back(stray);
  return {vertices, std::vector<TriangleIndices>(cube.triangles().begin(), cube.triangles().end())};
}

// A body is where its triangles are: not where a vertex without any is, nor where its frame is.
TEST(Sides, ABodyIsWhereItsTrianglesAre) {
  const Shape solid = tests::tessellated_box({2, 2, 2}, 2);
  const Shape sheet = HeightField(9, 9, std::vector<float>(81, 0.f));
  for (const Vector3d& stray : {Vector3d(3, 4, 5), Vector3d(-3, 0, 0), Vector3d(0, 0, -100)}) {
    for (const double offset : {0.0, 0x1p20, -0x1p30}) {
      const Vector3d moved(offset, -offset, offset);
      const Shape cube = cube_with(stray, moved);
      const auto at = [&](double x, double y, double z) {
        return tests::at(x - moved[0], y - moved[1], z - moved[2]);
      };
      SCOPED_TRACE((std::ostringstream() << stray.transpose() << " by " << offset).str());
      const Manifold out =
          find_contacts({solid}, {cube, at(1.5, 0.875, 0.875)}, {.sides_a = kSolid});
      ASSERT_FALSE(out.empty());
      EXPECT_NEAR(out[0].depth, 0.75, 1e-9);
      EXPECT_LT((out[0].normal - Vector3d(1, 0, 0)).norm(), 1e-9);
      const Manifold up = find_contacts({sheet}, {cube, at(4.25, 4.125, -0.75)},
                                        {.sides_a = MeshSides::one_sided(1)});
      ASSERT_FALSE(up.empty());
      EXPECT_NEAR(up[0].depth, 1, 1e-9);
      EXPECT_LT((up[0].normal - Vector3d(0, 0, 1)).norm(), 1e-9);
    }
  }
}

}  // namespace
}  // namespace graze

// Law 15: what is inside a solid mesh with hollows, as stairs are, has a way out, past which it is
// before the surface. Edges at the ends of a hollow spoke for a face that the body is not behind.

#include <graze/engine/mesh/containment.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/engine/way_out/tessellated.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;

constexpr MeshSides kSolid = MeshSides::solid();

/// Four steps of 0.3 m each way, from x = -0.6, and 0.9 m wide.
Mesh stairs(int cells, RandomSource& source) {
  std::vector<tests::Cube> cubes;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k <= i; ++k)
        cubes.push_back({i - 2, j - 1, k});
    }
  }
  return tests::surface_of_cubes(cubes, 0.3, cells, source);
}

/// A body inside; `radius` is of a ball within it.
struct Inside {
  Shape body;
  double radius;
};

std::vector<Inside> bodies(RandomSource& source) {
  const double r = source.uniform(0.01, 0.3), s = source.uniform(0.01, 0.05);
  const int rings = static_cast<int>(source.integer(3, 8));
  return {{Sphere{{0, 0, 0}, r}, r},
          {Box{{r, s, r}}, std::min(r, s)},
          {tests::tessellated_box({s, r, r}, 2), std::min(r, s)},
          {tests::make_sphere(r, rings, 2 * rings), 0.7 * r}};
}

TEST(SolidHollows, WhatIsInsideStairsHasAWayOut) {
  RandomSource source(1534);
  int inside = 0;
  for (int n = 0; n < 1500; ++n) {
    SCOPED_TRACE(n);
    const Mesh solid = stairs(1 + n % 2, source);
    for (const Inside& each : bodies(source)) {
      Pose pose = tests::random_pose(0, source);
      pose.translation() = Vector3d{source.uniform(-0.6, 0.6), source.uniform(-0.3, 0.6), 0};
      pose.translation().z() = source.uniform(0, 1.2);
      if (!contains({solid, Pose::Identity()}, pose.translation())) continue;
      const Manifold found = find_contacts({each.body, pose}, {Shape(solid)}, {.sides_b = kSolid});
      ASSERT_FALSE(found.empty());
      const MeshSides own = each.body.as<Mesh>() != nullptr ? kSolid : MeshSides();
      ASSERT_FALSE(
          find_contacts({Shape(solid)}, {each.body, pose}, {.sides_a = kSolid, .sides_b = own})
              .empty());
      if (intersects({each.body, pose}, {Shape(solid)})) continue;
      ++inside;
      // From inside to outside a ball goes by no less than its diameter, and lifted up it is out.
      ASSERT_GE(found[0].depth, 2 * each.radius);
      ASSERT_LE(found[0].depth, 1.2);
      if (each.body.kind() != ShapeKind::Sphere) continue;
      Pose away = pose;
      away.translation() -= (found[0].depth + 1e-9) * found[0].normal;
      ASSERT_FALSE(contains({solid, Pose::Identity()}, away.translation()));
    }
  }
  EXPECT_GT(inside, 500);
}

/// Beside a side wall of the stairs the contacts reach to the corners of the box's face, whichever
/// triangles of the wall these are over: at the end of a hollow too, where an edge of the wall has
/// a shorter way that does not lead out.
TEST(SolidHollows, AllTrianglesOfTheWallThatIsLeftHaveContacts) {
  RandomSource source(1535);
  int asked = 0;
  for (int n = 0; n < 3000; ++n) {
    const Mesh solid = stairs(1 + n % 2, source);
    const Vector3d half{source.uniform(0.02, 0.3), source.uniform(0.01, 0.1),
                        source.uniform(0.02, 0.3)};
    Pose pose = Pose::Identity();
    const Vector3d axis{source.uniform(-1, 1), source.uniform(-1, 1), source.uniform(-1, 1)};
    pose.linear() =
        Eigen::AngleAxisd(source.uniform(-0.2, 0.2), axis.normalized()).toRotationMatrix();
    pose.translation() = Vector3d{source.uniform(-0.6, 0.6), source.uniform(-0.25, 0.2), 0};
    pose.translation().z() = source.uniform(0, 1.2);
    const Shape box = Box{half};
    if (!contains({solid, Pose::Identity()}, pose.translation())) continue;
    if (intersects({box, pose}, {Shape(solid)})) continue;
    const Manifold found = find_contacts({box, pose}, {Shape(solid)}, {.sides_b = kSolid});
    ASSERT_FALSE(found.empty());
    if (found[0].normal.y() < 1 - 1e-9) continue;  // it leaves by another wall than that at -0.3 m
    double least = found[0].depth, least_of_corners = found[0].depth;
    bool is_over_wall = true;
    for (const ShapeContact& contact : found)
      least = std::min(least, contact.depth);
    for (const double x : {-half.x(), half.x()}) {
      for (const double z : {-half.z(), half.z()}) {
        const Vector3d corner = pose * Vector3d(x, half.y(), z);
        least_of_corners = std::min(least_of_corners, corner.y() + 0.3);
        const double height = 0.3 * (std::floor(corner.x() / 0.3) + 3);
        is_over_wall &= corner.z() > 0 && corner.z() < height && std::abs(corner.x()) < 0.6;
      }
    }
    // Of what is nearly level a corner may have moved towards a deeper point.
    if (!is_over_wall || least_of_corners > 0.9 * found[0].depth) continue;
    ++asked;
    ASSERT_NEAR(least, least_of_corners, 1e-9) << n;
  }
  EXPECT_GT(asked, 50);
}

/// Two boxes by their least and greatest coordinates.
Mesh two_boxes(const std::array<std::array<Vector3d, 2>, 2>& boxes) {
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (const auto& [least, most] : boxes) {
    const Mesh box = tests::make_box((most - least) / 2);
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const Vector3d& v : box.vertices())
      vertices.push_back(v + (least + most) / 2);
    for (const TriangleIndices& t : box.triangles())
      triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return {vertices, triangles};
}

// A plate stands in a large box below a small one, which hovers. Past the upright edge of the small
// box, and past the corner above it, the plate moves by 0.3 m at most, but it is below both.
TEST(SolidHollows, WhatIsBesideAnEdgeAndACornerDoesNotLeaveByThem) {
  const Vector3d out = Vector3d(1, 1, 0.14).normalized(), along = Vector3d(1, -1, 0).normalized();
  Pose pose = tests::at(0.05, -0.2, -1.25);
  pose.linear() << along, out.cross(along), out;
  const Vector3d half(0.6, 0.9, 0.05);
  const double width = pose.linear().row(0).cwiseAbs().dot(half);
  ASSERT_LT(pose.linear().row(2).cwiseAbs().dot(half), 0.95);  // it is inside the large one
  const Shape small_above = two_boxes({{{Vector3d(-0.6, -8, -8), Vector3d(8, 8, -0.25)},
                                        {Vector3d(-0.4, -0.4, -0.2), Vector3d(0, 0, 0.2)}}});
  for (const Shape& body : {Shape(Box{half}), Shape(tests::make_box(half))}) {
    const Manifold found = find_contacts({body, pose}, {small_above}, {.sides_b = kSolid});
    ASSERT_EQ(found.region_count(), 1u);
    EXPECT_NEAR(found[0].depth, 0.65 + width, 1e-12);
    EXPECT_TRUE((-found[0].normal).isApprox(-Vector3d::UnitX(), 1e-12));
  }
}

/// A ball whose vertices are at distances of 0.6 to all of its radius.
Mesh star(RandomSource& source) {
  const Mesh ball = tests::make_sphere(1.6, 6, 10);
  std::vector<Vector3d> vertices;
  for (const Vector3d& v : ball.vertices())
    vertices.push_back(v * source.uniform(0.6, 1));
  return {vertices, ball.triangles()};
}

// No way leads out of some hollows. There the nearest triangles decide, which share an edge.
TEST(SolidHollows, TheOrderOfTheTrianglesDoesNotDecide) {
  RandomSource source(1640);
  int inside = 0;
  for (int n = 0; n < 150; ++n) {
    const Mesh solid = star(source);
    std::vector<TriangleIndices> reversed(solid.triangles().begin(), solid.triangles().end());
    std::reverse(reversed.begin(), reversed.end());
    const Shape one = solid, other = Mesh(solid.vertices(), reversed);
    for (int k = 0; k < 40; ++k) {
      const Vector3d middle = source.vector(-1.5, 1.5);
      const double size = std::exp2(source.uniform(-4, -1));
      std::vector<Vector3d> corners;
      for (int i = 0; i < 3; ++i)
        corners.push_back(((middle + size * source.vector(-1, 1)) * 16).array().round() / 16);
      const Shape body = Mesh(corners, std::vector<TriangleIndices>{{0, 1, 2}});
      if (intersects({body}, {one})) continue;
      const Manifold by_one = find_contacts({body}, {one}, {.sides_b = kSolid});
      if (by_one.empty()) continue;
      ++inside;
      const Manifold by_other = find_contacts({body}, {other}, {.sides_b = kSolid});
      ASSERT_FALSE(by_other.empty());
      ASSERT_NEAR(by_one[0].depth, by_other[0].depth, 1e-9) << n << " " << k;
    }
  }
  EXPECT_GT(inside, 1000);
}

}  // namespace
}  // namespace graze

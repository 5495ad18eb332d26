// Meshes among themselves and beside convex shapes, at sizes up to the ends of the range of double:
// a power of two changes no bit of an answer but exponents. And the yes or no of a mesh and a
// convex shape agrees with their distance, however nearly they touch.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;

Vector3d scaled(const Vector3d& v, int exponent) {
  return {std::ldexp(v.x(), exponent), std::ldexp(v.y(), exponent), std::ldexp(v.z(), exponent)};
}

PlacedShape scaled(const Mesh& mesh, Pose pose, int exponent) {
  std::vector<Vector3d> vertices;
  for (const Vector3d& vertex : mesh.vertices())
    vertices.push_back(scaled(vertex, exponent));
  pose.translation() = scaled(pose.translation(), exponent);
  return {Shape(mesh.deformed(vertices)), pose};
}

void expect_scaled(const Manifold& found, const Manifold& expected, int exponent) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].normal, expected[i].normal);
    EXPECT_EQ(found[i].depth, std::ldexp(expected[i].depth, exponent));
    EXPECT_EQ(found[i].point_a, scaled(expected[i].point_a, exponent));
    EXPECT_EQ(found[i].point_b, scaled(expected[i].point_b, exponent));
    EXPECT_EQ(found[i].feature, expected[i].feature);
  }
}

TEST(MeshSizes, ContactsOfMeshesScaleWithThem) {
  RandomSource source(3);
  const std::vector<Mesh> meshes{tests::make_box({1, 0.5, 0.25}), tests::make_torus(1, 0.4, 12, 8),
                                 tests::make_sphere(0.75, 8, 10)};
  std::size_t contacts = 0;
  for (int n = 0; n < 12; ++n) {
    const Mesh& a = meshes[static_cast<std::size_t>(n) % 3];
    const Mesh& b = meshes[static_cast<std::size_t>(n) / 3 % 3];
    const Pose pose_a = n == 0 ? Pose::Identity() : tests::random_pose(0.3, source);
    const Pose pose_b = n == 0 ? Pose::Identity() : tests::random_pose(0.6, source);
    const Manifold expected = find_contacts({Shape(a), pose_a}, {Shape(b), pose_b});
    contacts += expected.size();
    for (const int exponent : {-320, -240, -200, -160, 140, 160, 210, 230, 250, 300, 325}) {
      SCOPED_TRACE(std::to_string(n) + ": 2^" + std::to_string(exponent));
      const PlacedShape large_a = scaled(a, pose_a, exponent),
                        large_b = scaled(b, pose_b, exponent);
      expect_scaled(find_contacts(large_a, large_b), expected, exponent);
    }
  }
  EXPECT_GT(contacts, 12u);
}

// Coordinates of a few times the least double: contacts end, and are there where the two touch.
TEST(MeshSizes, ContactsOfDenormalTriangles) {
  RandomSource source(4);
  int touching = 0;
  for (int n = 0; n < 200; ++n) {
    const double unit = std::ldexp(1.0, -1074 + 17 * (n % 4));
    const auto triangle = [&] {
      std::vector<Vector3d> corners;
      for (int i = 0; i < 3; ++i)
        corners.push_back(source.lattice_point(-4, 4) * unit);
      return Mesh(corners, std::vector<TriangleIndices>{{0, 1, 2}});
    };
    const Mesh a = triangle(), b = triangle();
    const bool is_hit = intersects({a}, {b});
    touching += is_hit;
    ASSERT_EQ(!find_contacts({Shape(a)}, {Shape(b)}).empty(), is_hit) << n;
  }
  EXPECT_GT(touching, 20);
}

// The cylinder's side passes a box's edge within the tolerance of distances.
TEST(MeshSizes, ADistanceIsNoneExactlyWhereShapesIntersect) {
  RandomSource source(5);
  const Mesh meshes[] = {tests::make_box({0.75, 2, 1}), tests::make_sphere(1, 6, 8)};
  const ShapeKind kinds[] = {ShapeKind::Capsule, ShapeKind::Cylinder, ShapeKind::Cone,
                             ShapeKind::Ellipsoid, ShapeKind::ConvexHull};
  int near = 0;
  for (int n = 0; n < 1500; ++n) {
    const Mesh& mesh = meshes[n % 2];
    const Shape shape = tests::random_shape(kinds[n % 5], 1, source);
    const Pose pose_a = tests::random_pose(0, source);
    Pose pose_b = tests::random_pose(0, source);
    if (n % 3 == 0) pose_b = pose_a;
    const Vector3d direction =
        n % 3 == 0 ? Vector3d(pose_a.linear().col(n / 3 % 3)) : source.vector(-1, 1).normalized();
    double clear = 9, meeting = 0;
    for (int step = 0; step < 60; ++step) {
      const double middle = 0.5 * (clear + meeting);
      pose_b.translation() = middle * direction;
      const bool is_hit = intersects({shape, pose_a}, {mesh, pose_b});
      const ShapeDistance gap = distance({shape, pose_a}, {mesh, pose_b});
      ASSERT_EQ(gap.distance == 0, is_hit) << n << " at " << middle;
      ASSERT_EQ(find_contacts({shape, pose_a}, {mesh, pose_b}).empty(), !is_hit) << n;
      ASSERT_LE(gap.lower_bound, gap.distance) << n;
      near += gap.distance > 0 && gap.distance < 1e-9;
      (is_hit ? meeting : clear) = middle;
    }
  }
  EXPECT_GT(near, 100);
}

}  // namespace
}  // namespace graze

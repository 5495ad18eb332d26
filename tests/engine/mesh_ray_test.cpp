#include <graze/bvh/error.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_ray.h>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <vector>

#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;

/// Every triangle by itself.
std::vector<RayHit> brute_force(const PlacedMesh& placed, const Ray& ray) {
  std::vector<RayHit> hits;
  for (std::uint32_t i = 0; i < placed.mesh.triangles().size(); ++i) {
    const auto hit = cast_ray(place(placed.pose, placed.mesh.triangle(i)), ray);
    if (hit) hits.push_back({hit->distance, hit->point, hit->normal, i});
  }
  std::sort(hits.begin(), hits.end(), [](const RayHit& s, const RayHit& t) {
    return std::tie(s.distance, s.triangle) < std::tie(t.distance, t.triangle);
  });
  return hits;
}

void expect_equal(const RayHit& s, const RayHit& t) {
  EXPECT_EQ(s.distance, t.distance);
  EXPECT_EQ(s.triangle, t.triangle);
  EXPECT_EQ(s.point, t.point);
  EXPECT_EQ(s.normal, t.normal);
}

std::size_t expect_brute_force(const PlacedMesh& placed, const Ray& ray) {
  const std::vector<RayHit> expected = brute_force(placed, ray), found = cast_ray_all(placed, ray);
  EXPECT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i)
    expect_equal(found[i], expected[i]);
  const auto first = cast_ray(placed, ray);
  EXPECT_EQ(first.has_value(), !expected.empty());
  if (first && !expected.empty()) expect_equal(*first, expected[0]);
  return expected.size();
}

/// At a corner, at a point of an edge, within a triangle, past it, or along an axis.
Ray ray_at(const PlacedMesh& placed, double distance, RandomSource& source) {
  const double count = static_cast<double>(placed.mesh.triangles().size());
  const auto index = static_cast<std::size_t>(source.uniform(0, count));
  const Triangle t = place(placed.pose, placed.mesh.triangle(index));
  const double what = source.uniform(0, 1), s = source.uniform(0, 1), r = source.uniform(0, 1);
  Vector3d target = t.a;
  if (what > 0.3) target = 0.5 * t.a + 0.5 * t.b;
  if (what > 0.5) target = t.a + r * ((1 - s) * (t.b - t.a) + s * (t.c - t.a));
  Ray ray{target + source.vector(-1, 1) * distance, {}};
  if (what > 0.9) {
    ray.origin = target;
    ray.direction = Vector3d::Unit(static_cast<int>(source.integer(0, 2)));
    ray.origin -= ray.direction * distance;
  } else {
    ray.direction = target - ray.origin;
  }
  if (what > 0.8) ray.direction += source.vector(-0.1, 0.1) * distance;
  if (source.uniform(0, 1) < 0.2) ray.max_distance = source.uniform(0, 2) * distance;
  return ray;
}

TEST(Law9MeshRay, TheTreeIsBruteForce) {
  RandomSource source(1);
  std::size_t hits = 0;
  for (int n = 0; n < 60; ++n) {
    const Mesh mesh = n % 3 == 0   ? tests::random_soup({.count = 200}, source)
                      : n % 3 == 1 ? tests::lattice_soup(120, 3, source)
                                   : tests::make_torus(1, 0.4, 14, 9);
    const double far = std::exp2(source.uniform(-10, 30));
    Pose pose = n % 4 == 0 ? Pose::Identity() : tests::random_pose(n % 4 == 1 ? far : 2, source);
    if (n % 5 == 0) pose = tests::distorted(pose, 9e-7, source);
    for (int i = 0; i < 60; ++i)
      hits += expect_brute_force({mesh, pose}, ray_at({mesh, pose}, i % 9 == 0 ? far : 3, source));
    ASSERT_FALSE(HasFailure()) << n;
  }
  EXPECT_GT(hits, 3000u);
}

TEST(Law9MeshRay, AtTheEndsOfDouble) {
  RandomSource source(2);
  std::size_t hits = 0;
  for (const double scale : {1e-320, 1e-300, 1e-150, 1e150, 1e300, 1e307}) {
    const Mesh mesh = tests::mapped(tests::make_torus(1, 0.4, 8, 6), scale, Vector3d::Zero());
    for (int i = 0; i < 60; ++i) {
      const PlacedMesh placed{mesh, i % 2 == 0 ? Pose::Identity() : tests::random_pose(0, source)};
      const Ray ray = ray_at(placed, 3 * scale, source);
      if (!ray.origin.allFinite() || !ray.direction.allFinite() || ray.direction.isZero(0))
        continue;
      hits += expect_brute_force(placed, ray);
    }
    ASSERT_FALSE(HasFailure()) << scale;
  }
  EXPECT_GT(hits, 300u);
}

/// A ray that begins inside a closed mesh meets it, wherever it aims; one from far outside that
/// aims at a corner, exactly, meets all triangles around it. The corners are on a lattice, so that
/// most rays go through corners and along edges and faces.
TEST(MeshRay, NothingSlipsThrough) {
  RandomSource source(3);
  const Mesh box = tests::make_box({2, 2, 2});
  const Mesh ball = tests::make_sphere(2, 12, 16);
  for (int n = 0; n < 4000; ++n) {
    Ray ray{source.lattice_point(-1, 1), source.lattice_point(-3, 3)};
    if (ray.direction.isZero()) continue;
    ASSERT_TRUE(cast_ray({box}, ray)) << n;
    const Pose pose = tests::random_pose(1, source);
    ray.origin = place(pose, Vector3d(0.5 * ray.origin));
    const Mesh& mesh = n % 2 == 0 ? box : ball;
    const auto corner = static_cast<std::size_t>(source.uniform(0, 8));
    ray.direction = place(pose, mesh.vertices()[corner]) - ray.origin;
    ASSERT_TRUE(cast_ray({mesh, pose}, ray)) << n;
  }
  for (int n = 0; n < 2000; ++n) {
    const Vector3d corner = box.vertices()[static_cast<std::size_t>(source.integer(0, 7))];
    const Vector3d origin = source.lattice_point(-50, 50);
    if (origin == corner) continue;
    std::size_t around = 0;
    for (std::size_t i = 0; i < box.triangles().size(); ++i) {
      const Triangle t = box.triangle(i);
      around += t.a == corner || t.b == corner || t.c == corner;
    }
    ASSERT_GE(cast_ray_all({box}, {origin, corner - origin}).size(), around);
  }
}

TEST(MeshRay, LooksOnlyWhereTheRayGoes) {
  const Mesh ball = tests::make_sphere(1, 60, 120);
  ASSERT_TRUE(cast_ray({ball}, {{0.1, 0.2, 5}, {0, 0, -1}}));
  Work work;
  const auto hit = cast_ray({ball}, {{0.1, 0.2, 5}, {0, 0, -1}}, &work);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 5 - std::sqrt(1 - 0.05), 2e-3);
  EXPECT_GT(hit->normal.z(), 0.9);
  EXPECT_LT(work.volume_tests, 200u);
  EXPECT_LT(work.triangle_tests, 40u);
  EXPECT_EQ(cast_ray_all({ball}, {{0.1, 0.2, 5}, {0, 0, -1}}).size(), 2u);
  EXPECT_THROW(cast_ray({ball}, {{0, 0, 0}, {0, 0, 0}}), InputError);
  Pose mirror = Pose::Identity();
  mirror.matrix()(0, 0) = -1;
  EXPECT_THROW(cast_ray({ball, mirror}, {{0, 0, 0}, {0, 0, 1}}), PoseError);
}

}  // namespace
}  // namespace graze

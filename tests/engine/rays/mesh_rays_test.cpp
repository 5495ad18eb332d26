// Rays at meshes beside brute force, where floats say little: needles, triangles without area,
// small parts far from each other, the ends of double, rays along edges, in planes and from afar.
// One ray a call, many a call, all hits, and whether there is any.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/data/mesh_rays.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/triangle_ray.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <thread>
#include <tuple>
#include <vector>

#include "tests/narrowphase/volumes/simd_targets.h"
#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;

std::vector<RayHit> each_by_itself(const PlacedMesh& placed, const Ray& ray) {
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

bool is_first(const std::optional<RayHit>& hit, const std::vector<RayHit>& all) {
  return hit ? !all.empty() && *hit == all[0] : all.empty();
}

std::size_t expect_all_alike(const PlacedMesh& placed, const std::vector<Ray>& rays) {
  std::vector<std::optional<RayHit>> firsts;
  cast_rays(placed, rays, firsts);
  std::size_t count = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::vector<RayHit> expected = each_by_itself(placed, rays[i]);
    EXPECT_TRUE(cast_ray_all(placed, rays[i]) == expected);
    EXPECT_TRUE(is_first(cast_ray(placed, rays[i]), expected));
    EXPECT_TRUE(is_first(firsts[i], expected));
    EXPECT_EQ(intersects(placed, rays[i]), !expected.empty());
    count += expected.size();
  }
  return count;
}

/// Needles whose width goes down to 2^-60 of their length.
Mesh needles(RandomSource& source) {
  std::vector<Vector3d> points;
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const Vector3d a = source.vector(-1, 1), along = source.vector(-1, 1);
    points.push_back(a);
    points.push_back(a + along);
    points.push_back(a + along * source.uniform(-0.5, 1.5) +
                     source.vector(-1, 1) * std::exp2(source.uniform(-60, -3)));
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return {points, triangles};
}

/// Corners of few places: most are equal, and many without area.
Mesh duplicates(RandomSource& source) {
  std::vector<Vector3d> points;
  std::vector<TriangleIndices> triangles;
  for (int i = 0; i < 12; ++i)
    points.push_back(source.lattice_point(-2, 2));
  const auto any = [&] { return static_cast<std::uint32_t>(source.integer(0, 11)); };
  for (int i = 0; i < 90; ++i)
    triangles.push_back({any(), any(), any()});
  return {points, triangles};
}

/// Triangles of sizes down to 2^-40 of the whole, which a grid across all cannot tell apart.
Mesh small_parts(RandomSource& source) {
  std::vector<Vector3d> points;
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const double size = std::exp2(source.uniform(-40, 0));
    const Vector3d middle = source.vector(-1, 1);
    for (int c = 0; c < 3; ++c)
      points.push_back(middle + size * source.vector(-1, 1));
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return {points, triangles};
}

Mesh some_mesh(int kind, RandomSource& source) {
  switch (kind % 6) {
    case 0:
      return needles(source);
    case 1:
      return duplicates(source);
    case 2:
      return small_parts(source);
    case 3:
      return tests::lattice_soup(80, 2, source);
    case 4:
      return tests::make_sphere(1, 9, 12);
    default:
      return tests::random_soup({.count = 100}, source);
  }
}

/// At corners, edges and faces; along edges and axes; with components that are zero, of either
/// sign, or denormal; from near and from afar, and some that end early.
std::vector<Ray> some_rays(const PlacedMesh& placed, double size, RandomSource& source) {
  std::vector<Ray> rays;
  const auto count = static_cast<double>(placed.mesh.triangles().size());
  for (int i = 0; i < 60; ++i) {
    const auto index = static_cast<std::size_t>(source.uniform(0, count));
    const Triangle t = place(placed.pose, placed.mesh.triangle(index));
    const double what = source.uniform(0, 1), s = source.uniform(0, 1), r = source.uniform(0, 1);
    Vector3d target = t.a;
    if (what > 0.25) target = 0.5 * t.a + 0.5 * t.b;
    if (what > 0.4) target = t.a + r * ((1 - s) * (t.b - t.a) + s * (t.c - t.a));
    const double far = size * (i % 5 == 0 ? std::exp2(source.uniform(-20, 45)) : 2);
    Ray ray{target + source.vector(-1, 1) * far, {}};
    ray.direction = target - ray.origin;
    if (what > 0.9) {
      ray.direction = Vector3d::Unit(i % 3) * (i % 2 == 0 ? -1 : 1);
      ray.origin = target - ray.direction * far;
    } else if (what > 0.8) {
      ray.direction = t.b - t.a;
      ray.origin = t.a - ray.direction * source.uniform(-1, 2);
    }
    if (i % 7 == 0) ray.direction[i % 3] = i % 2 == 0 ? 0.0 : -0.0;
    if (i % 11 == 0) ray.direction[i % 3] = 0x1p-1074 * source.integer(-3, 3);
    if (i % 13 == 0) ray.direction[i % 3] *= std::exp2(source.uniform(-80, -10));
    if (i % 8 == 0) ray.max_distance = source.uniform(0, 2) * far;
    if (ray.origin.allFinite() && ray.direction.allFinite() && !ray.direction.isZero(0))
      rays.push_back(ray);
  }
  return rays;
}

TEST(Law9MeshRays, AreBruteForceWhereFloatsSayLittle) {
  RandomSource source(1);
  std::size_t hits = 0;
  for (int n = 0; n < 60; ++n) {
    const Mesh mesh = some_mesh(n, source);
    Pose pose = Pose::Identity();
    if (n % 4 == 1) pose = tests::random_pose(2, source);
    if (n % 4 == 2) pose = tests::random_pose(std::exp2(source.uniform(0, 40)), source);
    if (n % 4 == 3) pose = tests::distorted(tests::random_pose(2, source), 9e-7, source);
    const PlacedMesh placed{mesh, pose};
    hits += expect_all_alike(placed, some_rays(placed, 2, source));
    ASSERT_FALSE(HasFailure()) << n;
  }
  EXPECT_GT(hits, 5000u);
}

TEST(Law9MeshRays, AreBruteForceAtAnyScale) {
  RandomSource source(2);
  std::size_t hits = 0;
  for (const double scale : {1e-310, 1e-200, 1e-150, 1e-38, 1e38, 1e150, 1e300}) {
    for (int n = 0; n < 6; ++n) {
      const Mesh mesh = tests::mapped(some_mesh(n, source), scale, Vector3d::Zero());
      const PlacedMesh placed{mesh, n % 2 == 0 ? Pose::Identity() : tests::random_pose(0, source)};
      hits += expect_all_alike(placed, some_rays(placed, 2 * scale, source));
      ASSERT_FALSE(HasFailure()) << scale << ' ' << n;
    }
  }
  EXPECT_GT(hits, 2000u);
}

TEST(Law8MeshRays, AnswersDoNotDependOnTheSimdTarget) {
  for (const std::int64_t target : simd_targets()) {
    force_simd_target(target);
    RandomSource source(3);
    for (int n = 0; n < 12; ++n) {
      const Mesh mesh = some_mesh(n, source);
      const PlacedMesh placed{mesh, n % 2 == 0 ? Pose::Identity() : tests::random_pose(1, source)};
      EXPECT_GT(expect_all_alike(placed, some_rays(placed, 2, source)), 0u);
      EXPECT_FALSE(HasFailure()) << n << ' ' << hwy::TargetName(target);
    }
    // Leaves of larger meshes share points, which are looked up otherwise for each width of a
    // register.
    const Mesh ball = tests::make_sphere(1, 30, 60);
    ASSERT_EQ(rays_of(ball).tree.leaves, bvh::RayLeaves::SharedPoints);
    EXPECT_GT(expect_all_alike({ball}, some_rays({ball}, 2, source)), 0u);
    EXPECT_FALSE(HasFailure()) << hwy::TargetName(target);
  }
  force_simd_target(0);
}

/// Floats decide nearly all: about one triangle a ray is placed, for where it is met.
TEST(MeshRays, PlaceHardlyMoreThanWhatTheyMeet) {
  const Mesh torus = tests::make_torus(1, 0.4, 120, 80);
  RandomSource source(4);
  Work work;
  std::size_t hits = 0;
  for (int n = 0; n < 1000; ++n) {
    const Vector3d origin = source.vector(-1, 1).normalized() * 4;
    const Vector3d target = torus.vertices()[static_cast<std::size_t>(source.integer(0, 5000))];
    hits += cast_ray({torus}, {origin, target + source.vector(-0.1, 0.1) - origin}, &work) ? 1 : 0;
  }
  EXPECT_GT(hits, 800u);
  EXPECT_GT(work.filter_tests, 3 * hits);
  EXPECT_LT(work.triangle_tests, hits + hits / 5);
  EXPECT_LT(work.exact_tests, 10u);
}

/// A ball drawn out along z, so that most of its faces are steep for rays that go there.
Mesh drawn_out() {
  constexpr std::uint32_t kRings = 40;
  constexpr double kPi = 3.14159265358979;
  std::vector<Vector3d> points;
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i <= kRings; ++i) {
    for (std::uint32_t j = 0; j < kRings; ++j) {
      const double polar = kPi * i / kRings, turn = 2 * kPi * j / kRings;
      points.emplace_back(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                          4 * std::cos(polar));
    }
  }
  for (std::uint32_t i = 0; i < kRings; ++i) {
    for (std::uint32_t j = 0; j < kRings; ++j) {
      const std::uint32_t a = i * kRings + j, b = i * kRings + (j + 1) % kRings;
      triangles.push_back({a, a + kRings, b});
      triangles.push_back({b, a + kRings, b + kRings});
    }
  }
  return {points, triangles};
}

/// With faces bounded by their far ends, 6,200 triangles are asked; else 5,000.
TEST(MeshRays, LookNoFurtherThanWhereASteepFaceIsMet) {
  const Mesh mesh = drawn_out();
  Work work;
  for (int x = -10; x <= 10; ++x) {
    for (int y = -10; y <= 10; ++y)
      cast_ray({mesh}, {{x / 10.0 + 0.013, y / 10.0 + 0.007, -8}, {0.001, 0.002, 1}}, &work);
  }
  EXPECT_LT(work.filter_tests, 5600u);
}

TEST(MeshRays, FirstUseByManyThreads) {
  for (int n = 0; n < 20; ++n) {
    const Mesh mesh = tests::make_sphere(1, 40, 40);
    std::vector<std::optional<RayHit>> hits(4);
    std::vector<std::thread> threads;
    for (auto& hit : hits)
      threads.emplace_back([&] { hit = cast_ray({mesh}, {{0.1, 0.2, 5}, {0, 0, -1}}); });
    for (std::thread& thread : threads)
      thread.join();
    for (const auto& hit : hits)
      EXPECT_TRUE(hit && hit == hits[0]);
  }
}

TEST(MeshRays, OfADeformedMesh) {
  const Mesh ball = tests::make_sphere(1, 20, 30);
  ASSERT_TRUE(cast_ray({ball}, {{0, 0, 5}, {0.01, 0.02, -1}}));
  std::vector<Vector3d> moved(ball.vertices().begin(), ball.vertices().end());
  for (Vector3d& v : moved)
    v = Vector3d(2 * v.x(), v.y() + 0.3 * v.x() * v.x(), v.z());
  RandomSource source(5);
  const PlacedMesh deformed{ball.deformed(moved), Pose::Identity()};
  EXPECT_GT(expect_all_alike(deformed, some_rays(deformed, 2, source)), 30u);
}

/// What the readme of engine/mesh/probe states.
TEST(MeshRays, TakeUpTo20BytesATriangle) {
  for (const Mesh& mesh : {tests::make_sphere(1, 60, 120), tests::make_torus(1, 0.3, 90, 60)}) {
    const std::size_t bytes = rays_of(mesh).tree.bytes();
    EXPECT_LE(static_cast<double>(bytes), 20.0 * static_cast<double>(mesh.triangles().size()));
  }
}

TEST(Law10MeshRays, RefuseWhatIsNoRay) {
  const Mesh box = tests::make_box({1, 1, 1});
  std::vector<std::optional<RayHit>> hits(1);
  const std::vector<Ray> rays{{{0, 0, 3}, {0, 0, -1}}, {{0, 0, 3}, {0, 0, 0}}};
  EXPECT_THROW(cast_rays({box}, rays, hits), InputError);
  EXPECT_EQ(hits.size(), 1u);
  EXPECT_THROW(intersects({box}, rays[1]), InputError);
  cast_rays({box}, std::span(rays).first(1), hits);
  EXPECT_EQ(hits[0]->distance, 2);
  cast_rays({box}, {}, hits);
  EXPECT_TRUE(hits.empty());
}

}  // namespace
}  // namespace graze

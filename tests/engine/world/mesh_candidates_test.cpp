// Contacts of two meshes that go through each other: against find_contacts() of the meshes, which
// is exact, against swapping, and from step to step. And boxes and balls on triangles, against the
// solvers of any convex sets.

#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/world.h>
#include <graze/narrowphase/convex/contact/contact_points.h>
#include <graze/narrowphase/convex/core/segments.h>
#include <graze/narrowphase/convex/gap/core_gap.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "tests/engine/mesh_io/allocated_bytes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::random_pose;

std::vector<Mesh> solids() {
  return {tests::make_sphere(1, 15, 24), tests::make_torus(1, 0.35, 40, 16),
          tests::make_box({1, 0.7, 0.4}), tests::make_sphere(0.6, 9, 12)};
}

/// B beside A along a random direction, that far in from where the two first touch.
struct Resting {
  Resting(const Mesh& of_a, const Mesh& of_b, double depth, RandomSource& source)
      : a(of_a), b(of_b), pose_a(random_pose(3, source)), pose_b(random_pose(0, source)) {
    const Vector3d way = source.vector(-1, 1).normalized();
    const Vector3d start = pose_a.translation();
    double clear = 4, touching = 0;
    for (int step = 0; step < 40; ++step) {
      const double middle = 0.5 * (clear + touching);
      pose_b.translation() = start + middle * way;
      (intersects({a, pose_a}, {b, pose_b}) ? touching : clear) = middle;
    }
    pose_b.translation() = start + (clear - depth) * way;
  }
  Manifold manifold() const { return find_contacts({Shape(a), pose_a}, {Shape(b), pose_b}); }

  Mesh a, b;
  Pose pose_a, pose_b;
};

template <typename Check>
void for_each_resting(double depth, Check&& check) {
  RandomSource source(41);
  const std::vector<Mesh> meshes = solids();
  for (int n = 0; n < 20; ++n) {
    for (const Mesh& a : meshes) {
      for (const Mesh& b : meshes) {
        const Resting pair(a, b, depth, source);
        const Manifold manifold = pair.manifold();
        ASSERT_EQ(manifold.empty(), !intersects({a, pair.pose_a}, {b, pair.pose_b}));
        if (!manifold.empty()) check(pair, manifold);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

TEST(MeshCandidates, FaceAndReachAsTheExactContactsDo) {
  int all = 0, alike = 0, as_deep = 0;
  for_each_resting(0.02, [&](const Resting& pair, const Manifold& manifold) {
    const MeshContacts exact = find_contacts({pair.a, pair.pose_a}, {pair.b, pair.pose_b});
    ASSERT_FALSE(exact.empty());
    const double size = 0.02;
    for (const ShapeContact& contact : manifold) {
      EXPECT_NEAR(contact.normal.norm(), 1, 1e-12);
      EXPECT_GE(contact.depth, 0);
      EXPECT_LT(contact.depth, 20 * size);
    }
    ++all;
    alike += manifold[0].normal.dot(exact[0].normal) > 0.95;
    const double ratio = manifold[0].depth / exact[0].depth;
    as_deep += ratio > 0.6 && ratio < 1.7;
  });
  EXPECT_GT(all, 250);
  EXPECT_GT(alike, 0.97 * all);
}

/// Pressed into the top of a table by 0.3, whatever the size of the triangles.
TEST(MeshCandidates, FineMeshesAreAsDeepAsCoarseOnes) {
  const Mesh table = tests::make_box({8, 8, 1});
  for (const int sectors : {12, 48, 192}) {
    const Mesh ball = tests::make_sphere(1, sectors / 2, sectors);
    const Pose pose(Eigen::Translation3d(0.0123, 0.0077, 1.7));
    const Manifold manifold = find_contacts({Shape(table), Pose::Identity()}, {Shape(ball), pose});
    ASSERT_FALSE(manifold.empty());
    EXPECT_EQ(manifold.region_count(), 1u);
    EXPECT_NEAR(manifold[0].depth, 0.3, 1e-9) << sectors;
    for (const ShapeContact& contact : manifold)
      EXPECT_NEAR(contact.normal.z(), 1, 1e-9) << sectors;
  }
}

Mesh moved_together(const Mesh& mesh, const std::vector<Vector3d>& places) {
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (const Vector3d& place : places) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const Vector3d& vertex : mesh.vertices())
      vertices.push_back(vertex + place);
    for (const TriangleIndices& t : mesh.triangles())
      triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return {vertices, std::span<const TriangleIndices>(triangles)};
}

/// Five teeth of one mesh in the two triangles of a table's top, the one in the middle the deepest.
TEST(MeshCandidates, EachToothIsAsDeepAsItIs) {
  const Mesh table = tests::make_box({8, 8, 1});
  const std::vector<Vector3d> places = {
      {-4, 0, 0.2}, {-2, 0, 0.1}, {0.1, 0, 0}, {2.2, 0, 0.1}, {4.3, 0, 0.2}};
  const Pose pose(Eigen::Translation3d(0.0123, 0.0077, 1.7));
  const auto depth_at = [](double x) {
    return std::abs(x) < 1.1 ? 0.3 : std::abs(x) < 3 ? 0.2 : 0.1;
  };
  for (const Mesh& tooth : {tests::make_box({0.4, 0.4, 1}), tests::make_sphere(1, 6, 12),
                            tests::make_sphere(1, 48, 96)}) {
    const Mesh teeth = moved_together(tooth, places);
    const MeshContacts exact = find_contacts({table, Pose::Identity()}, {teeth, pose});
    ASSERT_EQ(exact.size(), 5u);
    const Manifold manifold = find_contacts({Shape(table), Pose::Identity()}, {Shape(teeth), pose});
    ASSERT_EQ(manifold.region_count(), 5u);
    EXPECT_NEAR(manifold[0].depth, exact[0].depth, 1e-9);
    for (std::size_t n = 0; n < 5; ++n) {
      const ShapeContact& contact = manifold.region(n)[0];
      EXPECT_NEAR(contact.depth, depth_at(contact.point.x() - 0.1), 1e-9) << contact.point.x();
      EXPECT_NEAR(contact.normal.z(), 1, 1e-9);
    }
  }
}

TEST(MeshCandidates, SwappingMirrorsBitForBit) {
  for_each_resting(0.05, [&](const Resting& pair, const Manifold& manifold) {
    const Manifold other =
        find_contacts({Shape(pair.b), pair.pose_b}, {Shape(pair.a), pair.pose_a});
    ASSERT_EQ(other.size(), manifold.size());
    for (std::size_t i = 0; i < manifold.size(); ++i) {
      EXPECT_EQ(manifold[i].point, other[i].point);
      EXPECT_EQ(manifold[i].point_a, other[i].point_b);
      EXPECT_EQ(manifold[i].point_b, other[i].point_a);
      EXPECT_EQ(manifold[i].normal, -other[i].normal);
      EXPECT_EQ(manifold[i].depth, other[i].depth);
      EXPECT_EQ(manifold[i].feature.a, other[i].feature.b);
      EXPECT_EQ(manifold[i].feature.b, other[i].feature.a);
    }
  });
}

TEST(MeshCandidates, OfMeshesInOnePoseTheirVerticesDecideWhoIsFirst) {
  const Mesh a = tests::make_torus(1, 0.35, 40, 16), b = tests::make_sphere(0.9, 15, 24);
  const Pose pose = Pose::Identity();
  const Manifold m = find_contacts({Shape(a), pose}, {Shape(b), pose});
  const Manifold other = find_contacts({Shape(b), pose}, {Shape(a), pose});
  ASSERT_FALSE(m.empty());
  ASSERT_EQ(m.size(), other.size());
  for (std::size_t i = 0; i < m.size(); ++i) {
    EXPECT_EQ(m[i].point, other[i].point);
    EXPECT_EQ(m[i].normal, -other[i].normal);
  }
}

// The floor and the wall each part the two by as much as the box is behind them.
TEST(MeshCandidates, ABoxInACornerHasTwoRegions) {
  const Mesh room(
      std::vector<Vector3d>{{0, -4, 0}, {4, -4, 0}, {4, 4, 0}, {0, 4, 0}, {0, -4, 4}, {0, 4, 4}},
      std::vector<TriangleIndices>{{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {0, 5, 4}});
  Pose pose = Pose::Identity();
  pose.translation() = Vector3d(0.499, 0.1, 0.498);
  const Manifold m = find_contacts({Shape(room), Pose::Identity()},
                                   {Shape(tests::make_box({0.5, 0.5, 0.5})), pose});
  ASSERT_EQ(m.region_count(), 2u);
  EXPECT_NEAR(m.region(0)[0].depth, 0.002, 1e-12);
  EXPECT_NEAR((m.region(0)[0].normal - Vector3d(0, 0, 1)).norm(), 0, 1e-12);
  EXPECT_NEAR(m.region(1)[0].depth, 0.001, 1e-12);
  EXPECT_NEAR((m.region(1)[0].normal - Vector3d(1, 0, 0)).norm(), 0, 1e-12);
}

// Sunk into the middle of two large triangles: corners of the box, and how far it has sunk.
TEST(MeshCandidates, ABoxOnAPlaneHasFourCorners) {
  const Mesh ground(std::vector<Vector3d>{{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}},
                    std::vector<TriangleIndices>{{0, 1, 2}, {0, 2, 3}});
  Pose pose = Pose::Identity();
  pose.translation() = Vector3d(0.3, 0.1, 0.498);
  pose.rotate(Eigen::AngleAxisd(0.4, Vector3d::UnitZ()));
  const Manifold m = find_contacts({Shape(ground), Pose::Identity()},
                                   {Shape(tests::make_box({0.5, 0.5, 0.5})), pose});
  ASSERT_EQ(m.size(), 4u);
  for (const ShapeContact& contact : m) {
    EXPECT_NEAR(contact.depth, 0.002, 1e-12);
    EXPECT_NEAR(contact.normal.z(), 1, 1e-12);
    const Vector3d local = pose.linear().transpose() * (contact.point - pose.translation());
    EXPECT_NEAR(std::abs(local.x()), 0.5, 1e-9);
    EXPECT_NEAR(std::abs(local.y()), 0.5, 1e-9);
  }
}

TEST(MeshCandidates, FeaturesStayWhileMeshesMoveALittle) {
  RandomSource source(42);
  int all = 0, kept = 0;
  for_each_resting(0.02, [&](const Resting& pair, const Manifold& manifold) {
    Resting moved = pair;
    moved.pose_b.translation() += 1e-4 * source.vector(-1, 1);
    moved.pose_b.rotate(Eigen::AngleAxisd(1e-4, source.vector(-1, 1).normalized()));
    const Manifold next = moved.manifold();
    std::set<ContactFeature> unique;
    for (const ShapeContact& contact : next) {
      unique.insert(contact.feature);
      ++all;
      kept += std::any_of(manifold.begin(), manifold.end(), [&](const ShapeContact& before) {
        return before.feature == contact.feature;
      });
    }
    EXPECT_EQ(unique.size(), next.size());
  });
  EXPECT_GT(all, 500);
  EXPECT_GT(kept, 0.9 * all);
}

TEST(MeshCandidates, AStepOfMeshesAllocatesNothing) {
  World world;
  const std::vector<Mesh> meshes = solids();
  std::vector<BodyId> ids;
  for (int i = 0; i < 12; ++i) {
    Pose pose = Pose::Identity();
    pose.translation() = Vector3d(0.9 * (i % 4), 0.9 * (i / 4), 0.01 * i);
    ids.push_back(world.add({meshes[static_cast<std::size_t>(i) % 2], pose}));
  }
  std::size_t contacts = 0;
  const auto step = [&](int frame) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      Pose pose = world.pose(ids[i]);
      pose.translation().z() += 0.03 * ((static_cast<std::size_t>(frame) + i) % 2 == 0 ? 1 : -1);
      world.move(ids[i], pose);
    }
    contacts += world.update().contacts.size();
  };
  for (int frame = 0; frame < 20; ++frame)
    step(frame);
  const std::size_t before = mesh_io::allocated_bytes();
  for (int frame = 0; frame < 20; ++frame)
    step(frame);
  EXPECT_EQ(mesh_io::allocated_bytes(), before);
  EXPECT_GT(contacts, 200u);
}

using narrowphase::Core;
using narrowphase::CoreKind;
using narrowphase::Vec3;

Vec3 vec3(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

Core random_triangle(RandomSource& source) {
  Core triangle;
  triangle.kind = CoreKind::Triangle;
  for (Vec3& corner : triangle.corner)
    corner = vec3(source.vector(-1, 1));
  triangle.at = triangle.corner[0];
  triangle.bounding_radius =
      std::max(length(triangle.corner[1] - triangle.at), length(triangle.corner[2] - triangle.at));
  return triangle;
}

TEST(TriangleParting, IsTheLeastOfABox) {
  RandomSource source(43);
  int touching = 0;
  for (int n = 0; n < 2000; ++n) {
    const Core triangle = random_triangle(source);
    Core box;
    box.kind = CoreKind::Box;
    const Pose pose = random_pose(0.8, source);
    for (int k = 0; k < 3; ++k)
      box.axis[k] = vec3(pose.linear().col(k));
    box.at = vec3(pose.translation());
    box.half = vec3(source.vector(0.1, 0.8));
    box.bounding_radius = length(box.half);
    if (narrowphase::core_gap(box, triangle).upper > 0) continue;
    ++touching;
    const narrowphase::Parting found = part_from_triangle(box, triangle);
    const double least = narrowphase::penetration(box, triangle).depth;
    EXPECT_GE(found.penetration.depth, least - 1e-9);
    EXPECT_LE(found.penetration.depth, least / 0.95 + 1e-5);
    EXPECT_NEAR(along(box, triangle, found.penetration.normal).depth, found.penetration.depth,
                1e-12);
    if (!found.has_witnesses) continue;
    // The edges that meet are as far apart as the way out is long.
    const Vec3 between = found.penetration.point_a - found.penetration.point_b;
    EXPECT_NEAR(dot(between, found.penetration.normal), found.penetration.depth, 1e-9);
  }
  EXPECT_GT(touching, 500);
}

TEST(TriangleParting, IsToTheNearestPointOfABall) {
  RandomSource source(44);
  for (int n = 0; n < 2000; ++n) {
    const Core triangle = random_triangle(source);
    Core ball;
    ball.at = vec3(source.vector(-1.5, 1.5));
    const narrowphase::CoreGap gap = narrowphase::core_gap(ball, triangle);
    const Vec3 nearest = nearest_on_triangle(triangle, ball.at);
    EXPECT_NEAR(length(nearest - ball.at), gap.upper, 1e-9);
    ball.radius = gap.upper + 0.3;
    const narrowphase::Parting found = part_from_triangle(ball, triangle);
    EXPECT_NEAR(found.penetration.depth, 0.3, 1e-9);
    EXPECT_NEAR(length(found.penetration.normal), 1, 1e-12);
    EXPECT_GE(dot(found.penetration.normal, nearest - ball.at), 0);
  }
}

}  // namespace
}  // namespace graze

// Law 15: edges within a face do not exist, and over a curved surface normals lie between those of
// its facets.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/engine/way_out/tessellated.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;

/// A square of 4 m in the plane z = 0, cut by random points into triangles, slivers among them: a
/// fan from each point to the corners of the cell that it lies in.
Mesh flat_floor(int cells, RandomSource& source) {
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  const auto corner = [&](int i, int j) { return static_cast<std::uint32_t>(i * (cells + 1) + j); };
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j)
      vertices.push_back({4.0 * i / cells - 2, 4.0 * j / cells - 2, 0});
  }
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const double u = std::pow(source.uniform(0.02, 1), 3), v = source.uniform(0.01, 0.99);
      const auto middle = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back({4.0 * (i + u) / cells - 2, 4.0 * (j + v) / cells - 2, 0});
      const std::uint32_t around[] = {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                                      corner(i, j + 1)};
      for (int k = 0; k < 4; ++k)
        triangles.push_back({around[k], around[(k + 1) % 4], middle});
    }
  }
  return {vertices, std::span<const TriangleIndices>(triangles)};
}

TEST(WayOut, Law15WhatSlidesOverAFlatFloorFeelsNoEdges) {
  RandomSource source(157);
  for (int n = 0; n < 12; ++n) {
    const Mesh floor = flat_floor(4 + 5 * n, source);
    const Pose place = tests::random_pose(2, source);
    for (const ShapeKind kind : {ShapeKind::Sphere, ShapeKind::Box, ShapeKind::Capsule,
                                 ShapeKind::Cylinder, ShapeKind::Cone, ShapeKind::Ellipsoid}) {
      const Shape shape = tests::random_shape(kind, 0.3, source);
      Pose own = tests::random_pose(0, source);
      const double height = tests::reach_along(shape, own, {0, 0, -1}) - 0.01;
      const Vector3d down = place.linear() * Vector3d(0, 0, -1);
      for (int step = 0; step < 40; ++step) {
        own.translation() = Vector3d(0.03 * step - 0.6, 0.011 * step - 0.2, height);
        const Manifold found = find_contacts({shape, place * own}, {floor, place});
        ASSERT_EQ(found.region_count(), 1u) << name_of(kind) << " " << step;
        ASSERT_LE((found[0].normal - down).norm(), 1e-9) << name_of(kind) << " " << step;
        // Of a manifold with a face the corners may lack a little of the deepest point.
        ASSERT_NEAR(found[0].depth, 0.01, 2e-6) << name_of(kind) << " " << step;
      }
    }
  }
}

/// A ball rolls over a dome of facets: its normal is that of the facet or the edge below it.
// A body whose flat end leans by less than a millionth was led away along that end's normal from
// corners within the floor.
TEST(WayOut, Law15WhatLiesOnAFlatFloorWithAHairsLeanFeelsNoCorners) {
  RandomSource source(1571);
  for (int n = 0; n < 400; ++n) {
    const Shape floor = tests::tessellated_box({3, 3, 0.5}, 2 + n % 9);
    const double radius = source.uniform(0.2, 1), height = source.uniform(0.1, 0.5);
    const std::vector<Shape> bodies = {Box{{radius, 0.8 * radius, height}},
                                       Cylinder{radius, height}, Cone{radius, height}};
    for (const Shape& body : bodies) {
      Pose pose = tests::at({source.uniform(-1, 1), source.uniform(-1, 1), 0});
      const double lean = std::pow(10, source.uniform(-9, -5.5));
      pose.rotate(Eigen::AngleAxisd(lean, source.vector(-1, 1).normalized()));
      const double depth = std::pow(10, source.uniform(-7, -4));
      pose.translation().z() = 0.5 + tests::reach_of(body, pose, {0, 0, -1}) - depth;
      const Manifold found = find_contacts({floor, Pose::Identity()}, {body, pose});
      ASSERT_EQ(found.region_count(), 1u) << n;
      ASSERT_LE((found[0].normal - Vector3d::UnitZ()).norm(), 1e-9) << n;
      ASSERT_NEAR(found[0].depth, depth, 1e-3 * depth + 1e-9) << n;
    }
  }
}

// A point of an edge within the floor was looked for in one of its triangles, then in the other,
// and found in neither: the tip of a capsule over it was said to be half as deep.
TEST(WayOut, Law15WhatStandsOnAnEdgeWithinAFloorStandsOnTheFloor) {
  RandomSource source(1573);
  const Vector3d half(0.731, 0.159, 0.151);
  int pairs = 0;
  for (int cells = 1; cells <= 6; ++cells) {
    const Shape floor = tests::tessellated_box(half, cells);
    for (int i = 1; i < 2 * cells; ++i) {
      for (int j = 1; j < 2 * cells; ++j) {
        const double x = half.x() * (i - cells) / cells, y = half.y() * (j - cells) / cells;
        const double depth = 0.01, about = source.uniform(-3, 3);
        for (const Shape& body : {Shape(Capsule{0.1, 0.1}), Shape(Sphere{{0, 0, 0}, 0.2}),
                                  Shape(Ellipsoid{{0, 0, 0}, {0.1, 0.15, 0.2}})}) {
          Pose pose = tests::at(x, y, half.z() + 0.2 - depth);
          pose.rotate(Eigen::AngleAxisd(about, Vector3d::UnitZ()));
          const Manifold found = find_contacts({floor, Pose::Identity()}, {body, pose});
          ASSERT_FALSE(found.empty());
          if (found[0].normal.z() < 1 - 1e-9) continue;  // near the rim its edge is the way out
          ++pairs;
          ASSERT_NEAR(found[0].depth, depth, 1e-6) << cells << " " << i << " " << j;
        }
      }
    }
  }
  EXPECT_GT(pairs, 500);
}

// So it was from corners within a straight edge: where none of these is below the body, it had one
// contact with no depth.
TEST(WayOut, Law15ABoxThatLiesOnAStraightEdgeLiesOnAllOfIt) {
  RandomSource source(1572);
  const Vector3d half(0.6, 0.7, 0.1);
  const double top = std::sqrt(0.5) * (half.x() + half.z());
  for (int n = 0; n < 200; ++n) {
    const Shape ridge = tests::tessellated_box(half, 1 + n % 6);
    Pose of_ridge = Pose::Identity();
    of_ridge.rotate(Eigen::AngleAxisd(0.25 * std::numbers::pi, Vector3d::UnitY()));
    // The edge that is on top is at x = (half.x - half.z) sqrt(1/2), one way or the other.
    const Shape box = Box{{0.8, 0.5, 0.1}};
    const double lean = std::pow(10, source.uniform(-9, -7)), depth = 2e-4;
    const double shift = source.uniform(-0.6, 0.6);
    Pose pose = tests::at(source.uniform(-0.2, 0.2), shift, top + 0.1 - depth);
    pose.rotate(Eigen::AngleAxisd(lean, source.vector(-1, 1).normalized()));
    const Manifold found = find_contacts({ridge, of_ridge}, {box, pose});
    ASSERT_EQ(found.region_count(), 1u) << n;
    double low = 10, high = -10;
    for (const ShapeContact& contact : found) {
      EXPECT_NEAR(contact.depth, depth, 1e-6) << n;
      low = std::min(low, contact.point.y()), high = std::max(high, contact.point.y());
    }
    EXPECT_NEAR(low, std::max(-half.y(), shift - 0.5), 1e-6) << n;
    EXPECT_NEAR(high, std::min(half.y(), shift + 0.5), 1e-6) << n;
  }
}

TEST(WayOut, Law15OverADomeNormalsLieBetweenThoseOfFacets) {
  RandomSource source(158);
  std::vector<tests::ProfilePoint> profile;
  constexpr int kRings = 16;
  for (int i = 0; i <= kRings; ++i) {
    const double angle = std::numbers::pi * i / kRings;
    profile.push_back({i == 0 || i == kRings ? 0 : std::sin(angle), -std::cos(angle)});
  }
  const Mesh dome = tests::turned_profile(profile, 2 * kRings, {1, 1});
  const double facet = std::numbers::pi / kRings;
  for (int n = 0; n < 400; ++n) {
    const Vector3d way = source.vector(-1, 1).normalized();
    const double radius = source.uniform(0.1, 0.5);
    Pose pose = Pose::Identity();
    pose.translation() = way * (0.99 + radius);
    const Manifold found =
        find_contacts({Sphere{{0, 0, 0}, radius}, pose}, {dome, Pose::Identity()});
    if (found.empty()) continue;  // a facet's middle is deeper than that
    ASSERT_EQ(found.region_count(), 1u);
    ASSERT_GT(found[0].normal.dot(-way), std::cos(facet)) << n;
    const Vector3d nearest =
        distance({Sphere{{0, 0, 0}, 1e-3}, pose}, {dome, Pose::Identity()}).point_b;
    ASSERT_NEAR(found[0].depth, radius - (pose.translation() - nearest).norm(), 1e-9) << n;
  }
}

}  // namespace
}  // namespace graze

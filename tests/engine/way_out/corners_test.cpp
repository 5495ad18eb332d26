// Law 15 where a body meets more than one face of what is not convex: inner corners, bridges and
// holes narrower than the body, for shapes and for meshes.

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/world/convex_hull.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/engine/way_out/tessellated.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::Cube;

const Vector3d kDown(0, 0, -1);  // from a body above to what it lies on

/// Shapes of all kinds, and meshes.
std::vector<Shape> bodies(int n, RandomSource& source) {
  std::vector<Shape> all;
  for (const ShapeKind kind : {ShapeKind::Sphere, ShapeKind::Box, ShapeKind::Capsule,
                               ShapeKind::Cylinder, ShapeKind::Cone, ShapeKind::Ellipsoid})
    all.push_back(tests::random_shape(kind, 0.4, source));
  for (const auto kind : tests::kConvexMeshKinds)
    all.push_back(tests::convex_mesh(kind, n % 4, source));
  return all;
}

std::vector<Cube> floor_of(int size) {
  std::vector<Cube> cubes;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j)
      cubes.push_back({i, j, 0});
  }
  return cubes;
}

TEST(WayOut, Law15OnAFlatFloorTheNormalIsTheFloors) {
  RandomSource source(153);
  for (int n = 0; n < 40; ++n) {
    const Mesh floor = tests::surface_of_cubes(floor_of(4), 1, 1 << (n % 4), source);
    for (const Shape& shape : bodies(n, source)) {
      Pose pose = tests::random_pose(0, source);
      const double depth = std::pow(10, source.uniform(-5, -1.7));
      pose.translation() = Vector3d{source.uniform(1.6, 2.4), source.uniform(1.6, 2.4),
                                    1 + tests::reach_of(shape, pose, kDown) - depth};
      const Manifold found = find_contacts({shape, pose}, {floor, Pose::Identity()});
      SCOPED_TRACE((std::ostringstream() << n << " " << name_of(shape.kind())).str());
      ASSERT_EQ(found.region_count(), 1u);
      ASSERT_NEAR(found[0].depth, depth, 1e-6 + 1e-4 * depth);
      for (const ShapeContact& contact : found)
        ASSERT_LE((contact.normal - kDown).norm(), 1e-9);
    }
  }
}

/// A ball, whose ways out are known, in the corner of a floor and a wall.
TEST(WayOut, Law15InACornerThereAreTwoRegions) {
  RandomSource source(154);
  std::vector<Cube> cubes = floor_of(4);
  for (int i = 2; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      for (int k = 1; k < 4; ++k)
        cubes.push_back({i, j, k});
    }
  }
  for (int n = 0; n < 120; ++n) {
    const Mesh corner = tests::surface_of_cubes(cubes, 1, 1 << (n % 4), source);
    const double radius = source.uniform(0.3, 0.8);
    const double down = std::pow(10, source.uniform(-4, -1.7)),
                 aside = std::pow(10, source.uniform(-4, -1.7));
    const Pose pose = tests::at(2 - radius + aside, source.uniform(1.6, 2.4), 1 + radius - down);
    const Manifold found =
        find_contacts({Sphere{{0, 0, 0}, radius}, pose}, {corner, Pose::Identity()});
    ASSERT_EQ(found.region_count(), 2u) << n;
    for (const ShapeContact& contact : found) {
      const bool is_floor = (contact.normal - kDown).norm() < 1e-9;
      const Vector3d normal = is_floor ? kDown : Vector3d(1, 0, 0);
      ASSERT_LE((contact.normal - normal).norm(), 1e-9) << n;
      ASSERT_NEAR(contact.depth, is_floor ? down : aside, 1e-9) << n;
    }
    ASSERT_GE(found.region(0)[0].depth, found.region(1)[0].depth);
  }
}

/// A box whose middle lies beside both of the tables that it lies on.
TEST(WayOut, Law15ABridgeLiesOnBothOfItsPiers) {
  RandomSource source(155);
  std::vector<Cube> cubes;
  for (int j = 0; j < 4; ++j)
    cubes.push_back({0, j, 0}), cubes.push_back({3, j, 0});
  for (int n = 0; n < 60; ++n) {
    const Mesh piers = tests::surface_of_cubes(cubes, 1, 1 << (n % 4), source);
    const Vector3d half{source.uniform(1.2, 2.4), source.uniform(0.1, 0.6),
                        source.uniform(0.05, 0.3)};
    const double depth = std::pow(10, source.uniform(-4, -1.7));
    Pose pose = tests::at(2 + source.uniform(-0.1, 0.1), 2, 1 + half.z() - depth);
    pose.linear() =
        Eigen::AngleAxisd(source.uniform(-0.3, 0.3), Vector3d::UnitZ()).toRotationMatrix();
    for (const Shape& plank :
         {Shape(Box{half}), Shape(tests::tessellated_box(half, 1 << (n / 4 % 4)))}) {
      const Manifold found = find_contacts({plank, pose}, {piers, Pose::Identity()});
      // Curves of two meshes that rounding tears are of one piece.
      ASSERT_LE(found.region_count(), 2u) << n;
      if (plank.kind() == ShapeKind::Box) {
        ASSERT_EQ(found.region_count(), 2u) << n;
      }
      bool is_on_left = false, is_on_right = false;
      for (const ShapeContact& contact : found) {
        ASSERT_LE((contact.normal - kDown).norm(), 1e-6) << n;
        ASSERT_NEAR(contact.depth, depth, 1e-6 + 1e-3 * depth) << n;
        (contact.point.x() > 2 ? is_on_right : is_on_left) = true;
      }
      ASSERT_TRUE(is_on_left && is_on_right) << n << " " << name_of(plank.kind());
    }
  }
}

TEST(WayOut, Law15OverAHoleTheWallsSayNothing) {
  RandomSource source(156);
  std::vector<Cube> cubes = floor_of(5);
  std::erase(cubes, Cube{2, 2, 0});
  for (int n = 0; n < 60; ++n) {
    const Mesh floor = tests::surface_of_cubes(cubes, 0.3, 1 << (n % 4), source);
    const Vector3d half{source.uniform(0.3, 0.6), source.uniform(0.3, 0.6),
                        source.uniform(0.1, 0.3)};
    const double depth = std::pow(10, source.uniform(-4, -1.7));
    Pose pose = tests::at(0.75 + source.uniform(-0.05, 0.05), 0.75, 0.3 + half.z() - depth);
    pose.linear() = Eigen::AngleAxisd(source.uniform(0, 6), Vector3d::UnitZ()).toRotationMatrix();
    for (const Shape& lid :
         {Shape(Box{half}), Shape(tests::tessellated_box(half, 1 << (n / 4 % 4)))}) {
      const Manifold found = find_contacts({lid, pose}, {floor, Pose::Identity()});
      ASSERT_GE(found.region_count(), 1u) << n;
      for (const ShapeContact& contact : found) {
        ASSERT_LE((contact.normal - kDown).norm(), 1e-6) << n;
        ASSERT_NEAR(contact.depth, depth, 1e-6 + 1e-3 * depth) << n;
      }
    }
  }
}

/// What has sunk below an open surface leaves it in front, however deep it is.
TEST(WayOut, Law15MeshesAreOneSided) {
  const std::vector<Vector3d> vertices = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}};
  const std::vector<TriangleIndices> triangles = {{0, 1, 2}, {0, 2, 3}};
  const Mesh ground(vertices, std::span<const TriangleIndices>(triangles));
  for (const double height : {0.4, 0.1, 0.0, -0.1, -0.4}) {
    for (const Shape& shape :
         {Shape(Sphere{{0, 0, 0}, 0.5}), Shape(Box{{0.5, 0.5, 0.5}}), Shape(Capsule{0.25, 0.25})}) {
      const Manifold found =
          find_contacts({shape, tests::at(0.3, 0.1, height)}, {ground, Pose::Identity()});
      ASSERT_EQ(found.region_count(), 1u) << height;
      EXPECT_LE((found[0].normal - kDown).norm(), 1e-12) << height;
      EXPECT_NEAR(found[0].depth, 0.5 - height, 1e-9);
    }
  }
}

/// So do bodies that have sunk into a rough terrain to below their middle, however rough it is.
TEST(WayOut, Law15OfARoughTerrainNothingLeadsDown) {
  RandomSource source(159);
  constexpr int kSide = 40;
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (int i = 0; i <= kSide; ++i) {
    for (int j = 0; j <= kSide; ++j)
      vertices.push_back({0.1 * i - 2, 0.1 * j - 2, source.uniform(0, 0.06)});
  }
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const auto a = static_cast<std::uint32_t>(i * (kSide + 1) + j);
      triangles.push_back({a, a + kSide + 1, a + kSide + 2});
      triangles.push_back({a, a + kSide + 2, a + 1});
    }
  }
  const Mesh terrain(vertices, std::span<const TriangleIndices>(triangles));
  for (int n = 0; n < 300; ++n) {
    const double size = source.uniform(0.05, 0.4);
    const Pose pose = tests::at({source.uniform(-1.5, 1.5), source.uniform(-1.5, 1.5),
                                 0.03 + size * source.uniform(-0.5, 0.9)});
    for (const Shape& shape : {Shape(Sphere{{0, 0, 0}, size}), Shape(Box{{size, size, size}}),
                               Shape(Capsule{size, size}), Shape(Cylinder{size, size}),
                               Shape(Ellipsoid{{0, 0, 0}, {size, size, 0.8 * size}})}) {
      const Manifold found = find_contacts({shape, pose}, {terrain, Pose::Identity()});
      ASSERT_EQ(found.empty(), !intersects({shape, pose}, {terrain, Pose::Identity()}));
      for (const ShapeContact& contact : found) {
        ASSERT_LT(contact.normal.z(), 0) << n << " " << name_of(shape.kind());
        ASSERT_LE((contact.point_a - contact.point_b - contact.depth * contact.normal).norm(),
                  0x1p-16)
            << n << " " << name_of(shape.kind());
      }
    }
  }
}

/// A spike of so many triangles that share its tip: each asks the same of the tip.
TEST(WayOut, Law15ASpikeOfThousandsOfTrianglesIsLeftAtItsTip) {
  constexpr int kSectors = 20000;
  const std::vector<tests::ProfilePoint> profile = {{0, 0}, {1, 0}, {0, 0.3}};
  const Mesh spike = tests::turned_profile(profile, kSectors, {1, 1});
  const Manifold found =
      find_contacts({Box{{0.5, 0.5, 0.5}}, tests::at(0.01, 0.02, 0.79)}, {spike, Pose::Identity()});
  ASSERT_EQ(found.region_count(), 1u);
  EXPECT_LE((found[0].normal - kDown).norm(), 1e-9);
  EXPECT_NEAR(found[0].depth, 0.01, 1e-9);
}

/// Two boxes given as meshes, one on the other, leaning by next to nothing: of edges that cross the
/// outer end may be the deeper one by as little, which does not make the way up one round the body.
TEST(WayOut, Law15MeshesAtRestAreNotLedSideways) {
  RandomSource source(1518);
  int met = 0;
  for (int n = 0; n < 4000; ++n) {
    const auto sizes = [&] {
      return Vector3d{source.uniform(0.1, 1), source.uniform(0.1, 1), source.uniform(0.05, 0.5)};
    };
    const Vector3d below = sizes(), above = sizes();
    const Mesh lower = tests::tessellated_box(below, 1), upper = tests::tessellated_box(above, 1);
    const double turns[] = {0, source.uniform(-1e-3, 1e-3), source.uniform(-3, 3)};
    const double lean = std::pow(10, source.uniform(-7, -3));
    const double depth = std::pow(10, source.uniform(-7, -3));
    const Vector3d axis = Vector3d{source.uniform(-1, 1), source.uniform(-1, 1), 0}.normalized();
    Pose pose = Pose::Identity();
    pose.linear() =
        (Eigen::AngleAxisd(lean, axis) * Eigen::AngleAxisd(turns[n % 3], Vector3d::UnitZ()))
            .toRotationMatrix();
    const double aside_x = n % 2 == 0 ? source.uniform(-0.9, 0.9) : 0;
    const double aside_y = n % 4 >= 2 ? source.uniform(-0.9, 0.9) : 0;
    pose.translation() =
        Vector3d(aside_x * (below.x() + above.x()), aside_y * (below.y() + above.y()), 0);
    pose.translation().z() = below.z() + tests::reach_of(upper, pose, kDown) - depth;
    const Manifold found = find_contacts({Shape(lower), Pose::Identity()}, {Shape(upper), pose});
    if (found.empty()) continue;  // only a corner that hangs beside is as low
    ++met;
    EXPECT_GT(found[0].normal.z(), 0.9) << n;
    EXPECT_LT(found[0].depth, 1.06 * depth + 1e-9) << n;
  }
  EXPECT_GT(met, 2500);
}

/// Bodies of thousands of triangles that have fallen a few millimetres into a floor of many: what
/// they have in common has hundreds of crossings, and is left upwards all the same.
TEST(WayOut, Law15PiecesOfManyTrianglesAreLeftByTheFloor) {
  RandomSource source(1517);
  const Mesh floor = tests::surface_of_cubes(floor_of(4), 0.03, 16, source);
  for (const char* name : {"nut.stl", "bolt.obj"}) {
    const Mesh body = load_mesh(std::string(GRAZE_DATA_DIR) + "/meshes/" + name);
    for (int n = 0; n < 120; ++n) {
      Pose pose = tests::random_pose(0, source);
      const double depth = source.uniform(1e-4, 4e-3);
      pose.translation().setZero();
      pose.translation() = Vector3d(0.06, 0.06, 0.03 + tests::reach_of(body, pose, kDown) - depth);
      const Manifold found = find_contacts({Shape(body), pose}, {Shape(floor), Pose::Identity()});
      ASSERT_FALSE(found.empty());
      double deepest = 0;
      for (const ShapeContact& contact : found) {
        deepest = std::max(deepest, contact.depth);
        ASSERT_LE((contact.normal - kDown).norm(), 1e-6) << name << " " << n << " " << depth;
      }
      ASSERT_NEAR(deepest, depth, 1e-9) << name << " " << n;
    }
  }
}

/// What lies beside a tip reached farther than what is inside, by less than a twentieth: then the
/// way that left it out did not part the two, and another region was made of what remained.
TEST(WayOut, Law15ATipUnderARimIsOneRegion) {
  const double radius = 0.47726298149337132, half = 0.90660115411254338;
  const std::vector<tests::ProfilePoint> prism = {
      {0, -half}, {radius, -half}, {radius, half}, {0, half}};
  const double height = 0.54009232469503443;
  const std::vector<tests::ProfilePoint> cone = {
      {0, -height}, {0.75359681436812109, -height}, {0, height}};
  const Mesh a = tests::turned_profile(prism, 22, {1, 1}),
             b = tests::turned_profile(cone, 22, {1, 1});
  Pose pose(Eigen::AngleAxisd(3 * (std::numbers::pi / 2), Vector3d::UnitX()));
  pose.translation() = Vector3d(0.40142016203578867, 0.37475751217705122, 0.7980203090892124);
  const Manifold found = find_contacts({Shape(a), pose}, {Shape(b), Pose::Identity()});
  const Manifold truth = find_contacts({Shape(ConvexHull(a.vertices())), pose},
                                       {Shape(ConvexHull(b.vertices())), Pose::Identity()});
  ASSERT_EQ(found.region_count(), 1u);
  EXPECT_NEAR(found[0].depth, truth[0].depth, 0.05 * truth[0].depth);
  EXPECT_LT((found[0].normal - truth[0].normal).norm(), 1e-6);
}

}  // namespace
}  // namespace graze

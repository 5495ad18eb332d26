// Law 15: what is inside a convex solid leaves it by the nearest way, past a corner, too, and where
// it is flat along the face that it leaves.

#include <graze/engine/world/convex_hull.h>
#include <graze/engine/world/manifold.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/engine/way_out/tessellated.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;

constexpr MeshSides kSolid = MeshSides::solid();

/// A square at the bottom, its middle and its edges along x and y, and one above it.
Mesh frustum(double bottom, double z_bottom, double top, double z_top) {
  std::vector<Vector3d> vertices;
  for (const auto& [half, z] : {std::pair(bottom, z_bottom), std::pair(top, z_top)}) {
    for (const auto& [x, y] :
         {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
      vertices.push_back({half * x, half * y, z});
  }
  std::vector<TriangleIndices> triangles{{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t next = (i + 1) % 4;
    triangles.push_back({i, next, 4 + next});
    triangles.push_back({i, 4 + next, 4 + i});
  }
  return {vertices, triangles};
}

/// A pyramid on a pyramid, 0.2 m high each.
Mesh double_pyramid() {
  const std::vector<Vector3d> vertices{{1, 0, 0},  {0, 1, 0},   {-1, 0, 0},
                                       {0, -1, 0}, {0, 0, 0.2}, {0, 0, -0.2}};
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t next = (i + 1) % 4;
    triangles.push_back({i, next, 4});
    triangles.push_back({next, i, 5});
  }
  return {vertices, triangles};
}

/// Expects that a box, as a shape and as a mesh, is moved up by that depth.
void expect_up(const Shape& solid, const Vector3d& half, const Pose& in_solid, const Pose& frame,
               double depth) {
  const std::vector<Shape> bodies{Box{half}, tests::tessellated_box(half, 1),
                                  tests::tessellated_box(half, 2)};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    SCOPED_TRACE(i);
    const Manifold found =
        find_contacts({bodies[i], frame * in_solid}, {solid, frame}, {.sides_b = kSolid});
    ASSERT_EQ(found.region_count(), 1u);
    ASSERT_NEAR(found[0].depth, depth, 1e-9);
    ASSERT_TRUE((-found[0].normal).isApprox(frame.linear() * Vector3d::UnitZ(), 1e-9));
  }
}

TEST(SolidWays, Law15APlateLeavesPastABluntCorner) {
  RandomSource source(1561);
  const Shape solid = double_pyramid();
  for (int n = 0; n < 50; ++n) {
    SCOPED_TRACE(n);
    const Vector3d half{source.uniform(0.15, 0.2), source.uniform(0.15, 0.2), 0.02};
    Pose in_solid = tests::at({source.uniform(-0.1, 0.1), source.uniform(-0.1, 0.1), 0.05});
    in_solid.linear() =
        Eigen::AngleAxisd(source.uniform(0, 3), Vector3d::UnitZ()).toRotationMatrix();
    const Pose frame =
        n % 2 == 0 ? Pose::Identity() : tests::random_pose(n % 4 == 1 ? 1 : 1000, source);
    expect_up(solid, half, in_solid, frame, 0.17);
  }
}

// A triangle without area at the tip has no normal, or one that rounding makes.
TEST(SolidWays, Law15APlateLeavesPastATipWithASliver) {
  RandomSource source(1566);
  const Mesh whole = double_pyramid();
  for (int n = 0; n < 40; ++n) {
    SCOPED_TRACE(n);
    std::vector<Vector3d> vertices(whole.vertices().begin(), whole.vertices().end());
    const double share = n % 4 == 0 ? 0.5 : source.uniform(0.1, 0.9);
    vertices.push_back((1 - share) * vertices[4] + share * vertices[0]);
    std::vector<TriangleIndices> triangles(whole.triangles().begin(), whole.triangles().end());
    const auto beside = std::find(triangles.begin(), triangles.end(), TriangleIndices{0, 1, 4});
    ASSERT_NE(beside, triangles.end());
    *beside = {0, 1, 6};
    triangles.push_back({6, 1, 4});
    triangles.push_back({0, 6, 4});
    const Pose frame = n % 2 == 0 ? Pose::Identity() : tests::random_pose(1, source);
    expect_up(Mesh(vertices, triangles), {0.18, 0.18, 0.02}, tests::at(0, 0, 0.05), frame, 0.17);
  }
}

// Of a hull all faces are known, of a mesh those that are looked for.
TEST(SolidWays, Law15AMeshLeavesAsItsHullDoes) {
  RandomSource source(1563);
  const Shape solid = double_pyramid();
  for (int n = 0; n < 100; ++n) {
    SCOPED_TRACE(n);
    std::vector<Vector3d> vertices;
    const Mesh ball = tests::make_sphere(0.25, 4 + n % 5, 7 + n % 6);
    for (const Vector3d& v : ball.vertices())
      vertices.push_back({v.x(), v.y(), 0.05 * v.z() + source.uniform(0, 0.01)});
    const Shape mesh = Mesh(vertices, ball.triangles());
    Pose pose = tests::at({source.uniform(-0.05, 0.05), source.uniform(-0.05, 0.05), 0.02});
    pose.linear() = Eigen::AngleAxisd{source.uniform(-0.1, 0.1), source.vector(-1, 1).normalized()}
                        .toRotationMatrix();
    const Manifold of_mesh = find_contacts({mesh, pose}, {solid}, {.sides_b = kSolid});
    const Manifold of_hull =
        find_contacts({Shape(ConvexHull(vertices)), pose}, {solid}, {.sides_b = kSolid});
    ASSERT_EQ(of_mesh.region_count(), 1u);
    ASSERT_EQ(of_hull.region_count(), 1u);
    ASSERT_NEAR(of_mesh[0].depth, of_hull[0].depth, 1e-7);
    ASSERT_TRUE(of_mesh[0].normal.isApprox(of_hull[0].normal, 1e-6));
  }
}

/// A polytope with corners on a sphere.
Mesh random_polytope(double radius, RandomSource& source) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 20; ++i)
    points.push_back(radius * source.vector(-1, 1).normalized());
  const ConvexHull hull(points);
  std::vector<Vector3d> vertices;
  for (std::size_t i = 0; i < hull.vertex_count(); ++i)
    vertices.push_back(hull.vertex(i));
  std::vector<TriangleIndices> triangles;
  for (std::size_t i = 0; i < hull.facet_count(); ++i) {
    const auto facet = hull.facet(i);
    for (std::size_t k = 1; k + 1 < facet.size(); ++k)
      triangles.push_back({facet[0], facet[k], facet[k + 1]});
  }
  return {vertices, triangles};
}

// The corners of the polytopes face many directions, and the box has few faces.
TEST(SolidWays, Law15AMeshOfABoxLeavesNoLaterThanTheBox) {
  RandomSource source(1565);
  int inside = 0;
  for (int n = 0; n < 200; ++n) {
    const Shape solid = random_polytope(1.5, source);
    for (int k = 0; k < 20; ++k) {
      SCOPED_TRACE(n);
      const Vector3d half{source.uniform(0.2, 0.6), source.uniform(0.2, 0.6),
                          source.uniform(0.02, 0.2)};
      Pose pose = tests::at({source.uniform(-1, 1), source.uniform(-1, 1), source.uniform(-1, 1)});
      pose.linear() = Eigen::AngleAxisd{source.uniform(0, 3), source.vector(-1, 1).normalized()}
                          .toRotationMatrix();
      if (intersects({Box{half}, pose}, {solid})) continue;
      const Manifold of_box = find_contacts({Box{half}, pose}, {solid}, {.sides_b = kSolid});
      if (of_box.empty()) continue;
      const Shape mesh = tests::make_box(half);
      const Manifold of_mesh = find_contacts({mesh, pose}, {solid}, {.sides_b = kSolid});
      ASSERT_FALSE(of_mesh.empty());
      ASSERT_LT(of_mesh[0].depth, of_box[0].depth + 1e-7);
      pose.translation() -= of_mesh[0].normal * (of_mesh[0].depth + 1e-9);
      ASSERT_FALSE(intersects({mesh, pose}, {solid}));
      ASSERT_TRUE(find_contacts({mesh, pose}, {solid}, {.sides_b = kSolid}).empty());
      ++inside;
    }
  }
  EXPECT_GT(inside, 500);
}

// There all directions along the border of those that the tip faces are ones in which another of
// the disc's corners is last.
TEST(SolidWays, Law15AFineDiscLeavesPastAFineTip) {
  RandomSource source(1564);
  const tests::ProfilePoint tip[] = {{0, -8}, {10, -1.5}, {0, 1.5}};
  for (const int sectors : {9, 40, 100}) {
    const Shape solid = tests::turned_profile(tip, sectors, {1, 1});
    for (const int fine : {7, 30, 60}) {
      const tests::ProfilePoint disc[] = {{0, -0.05}, {2.2, -0.05}, {2.2, 0.05}, {0, 0.05}};
      const Shape body = tests::turned_profile(disc, fine, {1, source.uniform(0.3, 1)});
      Pose pose = tests::at({source.uniform(-0.05, 0.05), source.uniform(-0.05, 0.05), 0.5});
      pose.linear() = Eigen::AngleAxisd(source.uniform(0, 6), Vector3d::UnitZ()).toRotationMatrix();
      const Manifold found = find_contacts({body, pose}, {solid}, {.sides_b = kSolid});
      ASSERT_EQ(found.region_count(), 1u) << sectors << " " << fine;
      ASSERT_NEAR(found[0].depth, 1.05, 1e-9) << sectors << " " << fine;
      ASSERT_LT(found[0].normal.z(), -1 + 1e-9) << sectors << " " << fine;
    }
  }
}

// All of its last points are beside the face, but it covers the face.
TEST(SolidWays, Law15ABodyLeavesAFaceThatItCovers) {
  RandomSource source(1562);
  const Shape solid = frustum(8, -2, 0.5, 1);
  for (int n = 0; n < 50; ++n) {
    SCOPED_TRACE(n);
    const Vector3d half{source.uniform(0.6, 0.75), source.uniform(0.1, 0.75), 0.1};
    const Pose in_solid =
        tests::at({source.uniform(-0.05, 0.05), source.uniform(-0.05, 0.05), 0.7});
    const Pose frame = n % 2 == 0 ? Pose::Identity() : tests::random_pose(1, source);
    expect_up(solid, half, in_solid, frame, 0.4);
  }
}

}  // namespace
}  // namespace graze

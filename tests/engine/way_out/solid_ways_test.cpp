// Law 15: what is inside a convex solid leaves it by the nearest way, where it is flat along the
// face that it leaves, too.

#include <graze/engine/world/manifold.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/engine/way_out/tessellated.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;

constexpr MeshSides kSolidWay = MeshSides::solid();

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

/// Expects that a box, as a shape and as a mesh, is moved up by that depth.
void expect_up(const Shape& solid, const Vector3d& half, const Pose& in_solid, const Pose& frame,
               double depth) {
  const std::vector<Shape> bodies{Box{half}, tests::tessellated_box(half, 1),
                                  tests::tessellated_box(half, 2)};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    SCOPED_TRACE(i);
    const Manifold found =
        find_contacts({bodies[i], frame * in_solid}, {solid, frame}, {.sides_b = kSolidWay});
    ASSERT_EQ(found.region_count(), 1u);
    ASSERT_NEAR(found[0].depth, depth, 1e-9);
    ASSERT_TRUE((-found[0].normal).isApprox(frame.linear() * Vector3d::UnitZ(), 1e-9));
  }
}

// All of its last points are beside the face, but it covers the face.
TEST(SolidWays, Law15ABodyLeavesAFaceThatItCovers) {
  RandomSource source(1562);
  const Shape solid = frustum(8, -2, 0.5, 1);
  for (int n = 0; n < 50; ++n) {
    SCOPED_TRACE(n);
    const double half_x = source.uniform(0.6, 0.75), half_y = source.uniform(0.1, 0.75);
    const Vector3d half{half_x, half_y, 0.1};
    const double x = source.uniform(-0.05, 0.05), y = source.uniform(-0.05, 0.05);
    const Pose in_solid = tests::at(x, y, 0.7);
    const Pose frame = n % 2 == 0 ? Pose::Identity() : tests::random_pose(1, source);
    expect_up(solid, half, in_solid, frame, 0.4);
  }
}

}  // namespace
}  // namespace graze

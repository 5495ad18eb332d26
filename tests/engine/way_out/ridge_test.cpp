// Law 15 where edges in one line, or in one plane, are left in one direction: each may hold another
// part of the region.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;

/// A roof whose level ridge has a bend in its middle.
Mesh bent_roof(RandomSource& source) {
  const double bend = source.uniform(0.05, 0.35);
  const double low[] = {-source.uniform(0.2, 0.8), 0, -source.uniform(0.2, 0.8)};
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> faces;
  for (const double x : {-1., 0., 1.})
    for (int row = 0; row < 3; ++row)
      vertices.emplace_back(x, row - 1 + (x == 0 ? 0 : bend), low[row]);
  for (const std::uint32_t first : {0u, 1u, 3u, 4u}) {
    faces.push_back({first, first + 3, first + 4});
    faces.push_back({first, first + 4, first + 1});
  }
  return {vertices, faces};
}

// A level cylinder hangs over one edge of the ridge. Its lowest line is as high over the other
// edge, which is left first or last as rounding has it.
TEST(Ridges, ACylinderIsAsNearAsTheEdgeBelowIt) {
  constexpr double kMargin = 0.03;
  RandomSource source(1531);
  int asked = 0;
  for (int n = 0; n < 4000; ++n) {
    const Shape roof = bent_roof(source);
    const double radius = source.uniform(0.1, 0.4);
    const Shape cylinder = Cylinder{radius, source.uniform(0.2, 0.6)};
    const double along = source.uniform(-0.8, 0.8), gap = source.uniform(0, 0.02);
    Pose level = tests::at(along, 0, radius + gap);
    level.linear() = (Eigen::AngleAxisd(source.uniform(0, 3), Vector3d(0, 0, 1)) *
                      Eigen::AngleAxisd(std::acos(0.), Vector3d(1, 0, 0)))
                         .toRotationMatrix();
    const Pose frame = tests::random_pose(1, source), pose = frame * level;
    const double distance = graze::distance({cylinder, pose}, {roof, frame}).distance;
    if (distance == 0 || distance > kMargin) continue;
    ++asked;
    const Manifold found = find_contacts({cylinder, pose}, {roof, frame}, {.margin = kMargin});
    ASSERT_FALSE(found.empty());
    EXPECT_GE(found[0].depth, -1.001 * distance - 1e-6) << n;
  }
  EXPECT_GT(asked, 3000);
}

}  // namespace
}  // namespace graze

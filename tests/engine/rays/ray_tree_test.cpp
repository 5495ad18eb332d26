// The tree that rays walk holds what the binary one does, each primitive once, and within bounds.

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/data/mesh_rays.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

class Checked {
 public:
  explicit Checked(const Mesh& mesh)
      : mesh_(mesh), rays_(rays_of(mesh).tree), seen_(mesh.triangles().size()) {
    EXPECT_EQ(rays_.node(0).child_count, 1);
    look_at(rays_.node(0).child[0], 1);
    for (const int times : seen_)
      EXPECT_EQ(times, 1);
  }

 private:
  void look_at(std::uint32_t line, std::uint32_t depth) {
    EXPECT_LE((bvh::RayNode::kWidth - 1) * depth + 1, rays_.most_open);
    const bvh::RayNode& node = rays_.node(line);
    for (std::uint32_t lane = 0; lane < node.child_count; ++lane) {
      if (node.in_leaf[lane] == 0) {
        look_at(node.child[lane], depth + 1);
        continue;
      }
      ASSERT_LE(node.in_leaf[lane], bvh::RayTree::kLeafSize);
      for (std::uint32_t i = 0; i < node.in_leaf[lane]; ++i)
        look_at(node, lane, i);
    }
  }

  void look_at(const bvh::RayNode& node, std::uint32_t lane, std::uint32_t i) {
    const std::uint32_t primitive = rays_.primitives[node.child[lane] + i];
    ++seen_[primitive];
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t packed = node.corners(lane)[c * node.in_leaf[lane] + i];
      const Eigen::Vector3d& corner = mesh_.vertices()[mesh_.triangles()[primitive][c]];
      for (int k = 0; k < 3; ++k) {
        const double scale = node.scale[k];
        const double low = node.origin[k] + scale * node.box[k][lane];
        const double high = node.origin[k] + scale * node.box[k + 3][lane];
        const double y = std::ldexp(corner[k] - rays_.frame.centre[k], -rays_.frame.exponent);
        EXPECT_GE(y, low - 0x1p-50);
        EXPECT_LE(y, high + 0x1p-50);
        const double step = (high - low) / bvh::RayTree::kSteps;
        const std::uint32_t steps = packed >> (k * bvh::RayTree::kBits) & bvh::RayTree::kSteps;
        EXPECT_NEAR(y, low + step * steps, 0.5001 * step + 0x1p-50);
      }
    }
  }

  const Mesh& mesh_;
  const bvh::RayTree& rays_;
  std::vector<int> seen_;
};

TEST(RayTree, HoldsEachPrimitiveOnce) {
  RandomSource source(1);
  for (const std::size_t count : {1u, 2u, 7u, 8u, 9u, 16u, 17u, 64u, 65u, 500u}) {
    const Checked soup(tests::random_soup({.count = count}, source));
    const Checked lattice(tests::lattice_soup(count, 2, source));
    ASSERT_FALSE(testing::Test::HasFailure()) << count;
  }
  const Checked torus(tests::make_torus(1, 0.3, 60, 40));
}

}  // namespace
}  // namespace graze

// The tree that rays walk holds what the binary one does, each primitive once, and within bounds.

#include <graze/bvh/rays/ray_tree_walk.h>
#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/data/mesh_rays.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

class Checked {
 public:
  explicit Checked(const Mesh& mesh)
      : mesh_(mesh), rays_(rays_of(mesh).tree), seen_(mesh.triangles().size()) {
    look_at(rays_.node(0).child[0].where(), 1);
    for (const int times : seen_)
      EXPECT_EQ(times, 1);
  }

 private:
  void look_at(std::uint32_t where, std::uint32_t depth) {
    EXPECT_LE((bvh::RayNode::kWidth - 1) * depth + 1, rays_.most_open);
    const bvh::RayNode& node = rays_.node(where);
    for (std::uint32_t lane = 0; lane < bvh::RayNode::kWidth; ++lane) {
      if (node.box[0][lane] > node.box[1][lane]) {
        EXPECT_GT(lane, 0u);
        continue;
      }
      const bvh::RayChild child = node.child[lane];
      if (!child.is_leaf()) {
        look_at(child.where(), depth + 1);
        continue;
      }
      ASSERT_LE(child.count(), bvh::RayTree::kLeafSize);
      for (std::uint32_t i = 0; i < child.count(); ++i)
        look_at(node, lane, i);
    }
  }

  void look_at(const bvh::RayNode& node, std::uint32_t lane, std::uint32_t i) {
    const bvh::RayChild leaf = node.child[lane];
    const std::uint32_t* const words = rays_.leaf(leaf);
    const bool is_shared = rays_.leaves == bvh::RayLeaves::SharedPoints;
    const bvh::SharedPoints shared = is_shared ? *reinterpret_cast<const bvh::SharedPoints*>(words)
                                               : bvh::SharedPoints(leaf.place(), 1);
    const std::uint32_t primitive = rays_.primitives[shared.place() + i];
    ++seen_[primitive];
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t* const points = words + bvh::SharedPoints::kHeader;
      const std::uint32_t point = shared.corner(i, c);
      const std::uint32_t packed = is_shared ? points[point] : words[c * leaf.count() + i];
      if (is_shared) {
        ASSERT_LT(point, shared.count());
        EXPECT_EQ(points[shared.count() + point], mesh_.triangles()[primitive][c]);
      }
      const Eigen::Vector3d& corner = mesh_.vertices()[mesh_.triangles()[primitive][c]];
      for (int k = 0; k < 3; ++k) {
        const double low = node.box[2 * k][lane], high = node.box[2 * k + 1][lane];
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

TEST(RayChild, IsANodeOrALeaf) {
  constexpr std::uint32_t kLastPlace = (1u << bvh::RayChild::kPlaceBits) - 1;
  for (const std::uint32_t place : {0u, 1u, kLastPlace}) {
    for (std::uint32_t count = 1; count <= bvh::RayTree::kLeafSize; ++count) {
      const auto leaf = bvh::RayChild::leaf(place, count);
      EXPECT_TRUE(leaf.is_leaf());
      EXPECT_EQ(leaf.place(), place);
      EXPECT_EQ(leaf.count(), count);
    }
  }
  // As many nodes as a waiting child can name.
  const auto node = bvh::RayChild::node((1u << 29) - 1);
  EXPECT_FALSE(node.is_leaf());
  EXPECT_EQ(node.where(), (1u << 29) - 1);
}

TEST(RayTree, WithoutNodesLeavesAllToBeAsked) {
  const bvh::RayTree none{};
  const bvh::RayFrame frame{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}, {0, 0, 0}, 1, 0};
  const double origin[3] = {0, 0, 3}, direction[3] = {0, 0, -1};
  bvh::RayCandidate found[bvh::RayTreeWalk::kAtOnce];
  bvh::RayTreeWalk walk;
  EXPECT_EQ(walk.begin(none,
                       {.frame = frame,
                        .origin = origin,
                        .direction = direction,
                        .limit = 9,
                        .aim = bvh::RayAim::First,
                        .primitives = {}},
                       found),
            0u);
  EXPECT_TRUE(walk.is_blind());
}

TEST(RayTree, HoldsEachPrimitiveOnce) {
  RandomSource source(1);
  for (const std::size_t count : {1u, 2u, 7u, 8u, 9u, 16u, 17u, 64u, 65u, 500u}) {
    const Checked soup(tests::random_soup({.count = count}, source));
    const Checked lattice(tests::lattice_soup(count, 2, source));
    ASSERT_FALSE(testing::Test::HasFailure()) << count;
  }
  const Checked torus(tests::make_torus(1, 0.3, 60, 40));
}

// Four points of two triangles are few enough to be named in a leaf, and too many for its room.
TEST(RayTree, SharesNoPointsWhereThatTakesMoreRoom) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (int i = 0; i < 400; ++i) {
    const auto a = static_cast<std::uint32_t>(vertices.size());
    for (const Eigen::Vector3d& corner :
         {Eigen::Vector3d(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})
      vertices.push_back(corner + 2 * Eigen::Vector3d(i % 20, i / 20, 0));
    triangles.push_back({a, a + 1, a + 2});
    triangles.push_back({a, a + 2, a + 3});
  }
  const Mesh tiles(vertices, triangles);
  EXPECT_EQ(rays_of(tiles).tree.leaves, bvh::RayLeaves::Corners);
  const Checked checked(tiles);
}

/// A leaf can number sixteen points: eight triangles that share none have more.
TEST(RayTree, SharesNoPointsWhereALeafHasTooMany) {
  const Mesh ball = tests::make_sphere(1, 60, 120);
  ASSERT_EQ(rays_of(ball).tree.leaves, bvh::RayLeaves::SharedPoints);
  std::vector<Eigen::Vector3d> points(ball.vertices().begin(), ball.vertices().end());
  std::vector<TriangleIndices> triangles(ball.triangles().begin(), ball.triangles().end());
  for (int i = 0; i < 8; ++i) {
    const auto first = static_cast<std::uint32_t>(points.size());
    const Eigen::Vector3d at(4, 4 + 1e-3 * i, 4);
    points.insert(points.end(),
                  {at, at + Eigen::Vector3d(1e-3, 0, 0), at + Eigen::Vector3d(0, 0, 1e-3)});
    triangles.push_back({first, first + 1, first + 2});
  }
  const Mesh mesh(points, triangles);
  EXPECT_EQ(rays_of(mesh).tree.leaves, bvh::RayLeaves::Corners);
  const Checked checked(mesh);
}

TEST(RayTree, SharesPointsWhereNeighboursDo) {
  const Mesh ball = tests::make_sphere(1, 60, 120);
  std::vector<Eigen::Vector3d> own;
  std::vector<TriangleIndices> triangles;
  for (const TriangleIndices& t : ball.triangles()) {
    const auto first = static_cast<std::uint32_t>(own.size());
    triangles.push_back({first, first + 1, first + 2});
    for (const std::uint32_t v : t)
      own.push_back(ball.vertices()[v]);
  }
  const Mesh apart(own, triangles);
  EXPECT_EQ(rays_of(ball).tree.leaves, bvh::RayLeaves::SharedPoints);
  EXPECT_EQ(rays_of(apart).tree.leaves, bvh::RayLeaves::Corners);
  const Checked checked_ball(ball);
  const Checked checked_apart(apart);
  RandomSource source(3);
  for (int n = 0; n < 2000; ++n) {
    const Ray ray{source.vector(-2, 2), source.vector(-1, 1)};
    const auto hit = cast_ray({ball}, ray);
    EXPECT_TRUE(hit == cast_ray({apart}, ray));
    EXPECT_EQ(intersects({ball}, ray), hit.has_value());
    EXPECT_TRUE(cast_ray_all({ball}, ray) == cast_ray_all({apart}, ray));
  }
}

}  // namespace
}  // namespace graze

#include <graze/bvh/error.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/files/failed_case.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using tests::random_pose;

/// Law 9 for one box of either kind, or a ball. Returns how many triangles meet it.
template <typename Box>
std::size_t expect_brute_force(const PlacedMesh& placed, const Box& box) {
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < placed.mesh.triangles().size(); ++i) {
    if (intersects(place(placed.pose, placed.mesh.triangle(i)), box)) expected.push_back(i);
  }
  const tests::CaseOnFailure keep([&] {
    return tests::by_brute_force(
        to_case(placed, box, TriangleList{expected, Completeness::Complete}));
  });
  const TriangleList found = find_triangles(placed, box);
  EXPECT_EQ(found.triangles, expected);
  EXPECT_EQ(found.completeness, Completeness::Complete);
  EXPECT_EQ(intersects(placed, box), !expected.empty());
  for (const Volume volume : kVolumes) {
    EXPECT_EQ(find_triangles(placed, box, {.volume = volume}).triangles, expected)
        << name_of(volume);
    EXPECT_EQ(intersects(placed, box, {.volume = volume}), !expected.empty()) << name_of(volume);
  }
  return expected.size();
}

TEST(Law9Box, SoupsAndVolumesOfEachKind) {
  RandomSource source(1);
  std::size_t aligned = 0, oriented = 0, balls = 0;
  for (int n = 0; n < 400; ++n) {
    const double offset = n % 4 == 0 ? 1e9 : 0;
    const Eigen::Vector3d centre = Eigen::Vector3d(1, 2, -1) * offset;
    const Mesh mesh = tests::random_soup({.count = 100}, source);
    Pose pose = random_pose(0.5, source);
    pose.translation() += centre;
    if (n % 5 == 0) pose = tests::distorted(pose, 1e-6, source);
    const Eigen::Vector3d p = centre + source.vector(-1, 1), q = centre + source.vector(-1, 1);
    Aabb box{p.cwiseMin(q), p.cwiseMax(q)};
    if (n % 3 == 0) box.max[n % 9 / 3] = box.min[n % 9 / 3];  // flat
    aligned += expect_brute_force({mesh, pose}, box);
    Obb turned{random_pose(0.5, source), source.vector(0, 0.5)};
    turned.pose.translation() += centre;
    if (n % 7 == 0) turned.pose = tests::distorted(turned.pose, 1e-6, source);
    oriented += expect_brute_force({mesh, pose}, turned);
    balls += expect_brute_force({mesh, pose}, Sphere{p, source.uniform(0, 1)});
  }
  EXPECT_GT(aligned, 2000u);
  EXPECT_GT(oriented, 1000u);
  EXPECT_GT(balls, 1000u);
}

TEST(Law9Box, LatticesTouchingEverywhere) {
  RandomSource source(2);
  for (int n = 0; n < 200; ++n) {
    const Mesh mesh = tests::lattice_soup(60, 3, source);
    const Eigen::Vector3d p = source.lattice_point(-3, 3), q = source.lattice_point(-3, 3);
    expect_brute_force({mesh}, Aabb{p.cwiseMin(q), p.cwiseMax(q)});
    Obb box{Pose::Identity(), source.lattice_point(0, 2)};
    box.pose.translation() = p;
    expect_brute_force({mesh}, box);
    expect_brute_force({mesh}, Sphere{q, source.integer(0, 3)});
  }
}

TEST(Law9Box, ExtremeScales) {
  RandomSource source(3);
  for (double scale : {1e-310, 1e-160, 1e150, 1e300}) {
    std::size_t met = 0;
    for (int n = 0; n < 10; ++n) {
      const Mesh mesh =
          tests::random_soup({.count = 60, .extent = scale, .size = 0.3 * scale}, source);
      const Eigen::Vector3d p = source.vector(-1, 1) * scale, q = source.vector(-1, 1) * scale;
      met += expect_brute_force({mesh, random_pose(0.2 * scale, source)},
                                Aabb{p.cwiseMin(q), p.cwiseMax(q)});
      met += expect_brute_force({mesh},
                                Obb{random_pose(0.2 * scale, source), source.vector(0, 1) * scale});
      const Pose pose = random_pose(0.2 * scale, source);
      met += expect_brute_force({mesh, pose}, Sphere{p, source.uniform(0, 1) * scale});
    }
    EXPECT_GT(met, 50u) << scale;
  }
}

TEST(Law5Box, ACornerThatTouchesIsNeverPruned) {
  RandomSource source(4);
  for (int n = 0; n < 2000; ++n) {
    const Mesh mesh = tests::random_soup({.count = 4}, source);
    const Pose pose = random_pose(std::pow(10.0, source.integer(0, 9)), source);
    const Eigen::Vector3d corner = place(pose, mesh.triangle(1).a);
    ASSERT_TRUE(intersects({mesh, pose}, Aabb{corner, corner + source.vector(0, 10)})) << n;
    for (const Volume volume : kVolumes) {
      ASSERT_TRUE(intersects({mesh, pose}, Aabb{corner, corner}, {.volume = volume})) << n;
      ASSERT_TRUE(intersects({mesh, pose}, Sphere{corner, 0}, {.volume = volume})) << n;
    }
  }
}

// Beyond the range of double there is no vertex, but a ball may reach there.
TEST(Law9Box, BallsThatReachBeyondTheRange) {
  const Mesh mesh = tests::make_sphere(1e307, 10, 10);
  const std::size_t all = mesh.triangles().size();
  EXPECT_EQ(expect_brute_force({mesh}, Sphere{{1e308, 0, 0}, 1.7e308}), all);
  const std::size_t half = expect_brute_force({mesh}, Sphere{{-1.7e308, 0, 0}, 1.7e308});
  EXPECT_GT(half, all / 3);
  EXPECT_LT(half, all * 2 / 3);
  EXPECT_EQ(expect_brute_force({mesh}, Sphere{{1e308, 0, 0}, 0.5e308}), 0u);
}

TEST(BoxQuery, LimitsGiveTrueTrianglesAndSaySo) {
  const Mesh sphere = tests::make_sphere(1, 20, 20);
  const Aabb box{{0, -2, -2}, {2, 2, 2}};
  const TriangleList all = find_triangles({sphere}, box);
  const TriangleList some = find_triangles({sphere}, box, {.limit = 5});
  ASSERT_GT(all.size(), 5u);
  EXPECT_EQ(some.size(), 5u);
  EXPECT_EQ(some.completeness, Completeness::LimitReached);
  EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
}

TEST(Law10Box, BadBoxesAreRefused) {
  const Mesh sphere = tests::make_sphere(1, 4, 4);
  EXPECT_THROW(intersects({sphere}, Aabb{{0, 0, 0}, {1, -1, 1}}), InputError);
  EXPECT_THROW(find_triangles({sphere}, Aabb{{0, 0, 0}, {1, std::nan(""), 1}}), InputError);
  EXPECT_THROW(intersects({sphere}, Obb{Pose::Identity(), {1, -1, 1}}), InputError);
  EXPECT_THROW(intersects({sphere}, Sphere{{0, 0, 0}, -1}), InputError);
  EXPECT_THROW(find_triangles({sphere}, Sphere{{0, std::nan(""), 0}, 1}), InputError);
  Obb reflected{Pose::Identity(), {1, 1, 1}};
  reflected.pose.linear()(0, 0) = -1;
  EXPECT_THROW(find_triangles({sphere}, reflected), PoseError);
}

// Law 3's subtraction overflows for the far triangle alone, which the tree would prune: the door
// must not leave the answer to that.
TEST(Law10Box, AMeshThatCouldOverflowInTheFrameOfTheBoxIsRefused) {
  const std::vector<Eigen::Vector3d> vertices{{1.7e308, 0, 0}, {1.7e308, 1, 0}, {1.7e308, 0, 1},
                                              {0, 0, 0},       {1, 0, 0},       {0, 1, 0}};
  const std::vector<TriangleIndices> triangles{{0, 1, 2}, {3, 4, 5}};
  const Mesh mesh(vertices, triangles);
  Obb box{Pose::Identity(), {1, 1, 1}};
  EXPECT_EQ(find_triangles({mesh}, box).size(), 1u);
  box.pose.translation().x() = -1.7e308;
  EXPECT_THROW(find_triangles({mesh}, box), PoseError);
  EXPECT_THROW(intersects({mesh}, box), PoseError);
  EXPECT_THROW(intersects(mesh.triangle(0), box), InputError);
  EXPECT_FALSE(intersects(mesh.triangle(1), box));
}

}  // namespace
}  // namespace graze

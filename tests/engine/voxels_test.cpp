#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/engine/mesh/voxels.h>
#include <graze/narrowphase/triangle_box.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/engine/rational_containment.h"
#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

template <typename IsWanted>
std::vector<Voxel> filtered(const VoxelGrid& grid, IsWanted&& is_wanted) {
  std::vector<Voxel> voxels;
  for (std::uint32_t k = 0; k < grid.counts[2]; ++k) {
    for (std::uint32_t j = 0; j < grid.counts[1]; ++j) {
      for (std::uint32_t i = 0; i < grid.counts[0]; ++i) {
        const Voxel voxel{static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j),
                          static_cast<std::uint16_t>(k)};
        if (is_wanted(grid.box(voxel))) voxels.push_back(voxel);
      }
    }
  }
  return voxels;
}

bool touches(const Mesh& mesh, const Aabb& box) {
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    if (intersects(mesh.triangle(i), box)) return true;
  }
  return false;
}

/// Law 9: every voxel by every triangle. Returns how many voxels are touched.
std::size_t expect_brute_surface(const Mesh& mesh, std::uint32_t resolution) {
  const Voxels found = find_voxels(mesh, {.resolution = resolution});
  const auto expected = filtered(found.grid, [&](const Aabb& box) { return touches(mesh, box); });
  EXPECT_EQ(found.voxels, expected) << resolution;
  return expected.size();
}

/// The same with the parity of a rational ray for those that no triangle touches. Returns how many
/// of these are inside.
std::size_t expect_brute_solid(const Mesh& mesh, std::uint32_t resolution) {
  const Voxels found = find_voxels(mesh, {.resolution = resolution, .fill = VoxelFill::Solid});
  std::size_t inside = 0;
  const auto expected = filtered(found.grid, [&](const Aabb& box) {
    if (touches(mesh, box)) return true;
    const bool is_inside = oracle::contains_by_slanted_ray(mesh, box.min);
    inside += is_inside;
    return is_inside;
  });
  EXPECT_EQ(found.voxels, expected) << resolution;
  return inside;
}

TEST(Law9Voxels, SoupsByEveryTriangleAndVoxel) {
  RandomSource source(1);
  std::size_t touched = 0;
  for (int n = 0; n < 60; ++n) {
    const double size = std::pow(10.0, source.uniform(-2, 0.5));
    const Mesh mesh = tests::random_soup({.count = 1 + 2u * n, .size = size}, source);
    touched += expect_brute_surface(mesh, 1 + static_cast<std::uint32_t>(n) % 17);
  }
  EXPECT_GT(touched, 5000u);
}

TEST(Law9Voxels, TrianglesOnTheFacesOfVoxelsTouchBothSides) {
  RandomSource source(2);
  for (int n = 0; n < 100; ++n) {
    const Mesh mesh = tests::lattice_soup(1 + n % 20, 4, source);
    expect_brute_surface(mesh, 1 + n % 16);
  }
  // A plane between two layers belongs to both; one at the end of the grid to the last.
  const std::vector<Eigen::Vector3d> vertices{{0, 0, 0}, {4, 0, 0}, {0, 4, 0},
                                              {4, 4, 0}, {0, 0, 1}, {0, 0, 4}};
  const std::vector<TriangleIndices> quad{{0, 1, 2}, {1, 3, 2}, {4, 4, 4}};
  const std::vector<TriangleIndices> reaching{{0, 1, 2}, {1, 3, 2}, {5, 5, 5}};
  EXPECT_EQ(find_voxels(Mesh(vertices, quad), {.resolution = 4}).size(), 16u)
      << "the point on top touches a voxel that the quad touches from below";
  EXPECT_EQ(find_voxels(Mesh(vertices, reaching), {.resolution = 4}).size(), 17u);
  const Mesh row = tests::mapped(Mesh(vertices, reaching), 1, {0, 0, -2});
  EXPECT_EQ(find_voxels(row, {.resolution = 2}).size(), 5u);
  const std::vector<Eigen::Vector3d> middle{{0, 0, 2}, {4, 0, 2}, {0, 4, 2}, {0, 0, 0}, {4, 4, 4}};
  const std::vector<TriangleIndices> between{{0, 1, 2}, {3, 3, 3}, {4, 4, 4}};
  EXPECT_EQ(find_voxels(Mesh(middle, between), {.resolution = 2}).size(), 8u);
}

TEST(Law9Voxels, SolidsByParityInRationals) {
  RandomSource source(3);
  std::size_t inside = 0;
  for (int n = 0; n < 14; ++n) {
    inside += expect_brute_solid(tests::random_tetrahedra(1 + n % 3, 1, source), 6 + n % 9);
    inside += expect_brute_solid(tests::lattice_tetrahedra(1 + n % 3, 3, source), 6 + n % 9);
  }
  EXPECT_GT(inside, 20u);
  EXPECT_EQ(expect_brute_solid(tests::make_box({1, 1, 1}), 8), 6u * 6 * 6);
  EXPECT_GT(expect_brute_solid(tests::make_torus(1, 0.5, 5, 4), 11), 10u);
  EXPECT_GT(expect_brute_solid(tests::make_sphere(1, 3, 5), 9), 100u);
}

TEST(Law9Voxels, SolidsAreWhatContainsSays) {
  RandomSource source(7);
  for (const Mesh& mesh :
       {tests::make_torus(1, 0.3, 40, 20), tests::random_tetrahedra(5, 1, source),
        tests::lattice_tetrahedra(12, 8, source)}) {
    const Voxels solid = find_voxels(mesh, {.resolution = 32, .fill = VoxelFill::Solid});
    const auto expected = filtered(solid.grid, [&](const Aabb& box) {
      return intersects({mesh}, box) || contains(mesh, box.min);
    });
    EXPECT_EQ(solid.voxels, expected);
  }
}

TEST(Law9Voxels, ScalesAndOffsets) {
  RandomSource source(4);
  std::size_t touched = 0, inside = 0;
  for (double scale : {1e-318, 1e-150, 1e-20, 1e150, 1e300}) {
    const Mesh soup = tests::random_soup({.count = 20}, source);
    touched += expect_brute_surface(tests::mapped(soup, scale, Eigen::Vector3d::Zero()), 9);
    const Mesh solid = tests::mapped(tests::make_sphere(1, 2, 4), 1, source.vector(-1, 1));
    inside += expect_brute_solid(tests::mapped(solid, scale, Eigen::Vector3d::Zero()), 7);
  }
  for (double scale : {1e-6, 1e-3, 1.0}) {
    const Eigen::Vector3d offset(1e9, -1e9, 1e9 / 3);
    const Mesh soup = tests::random_soup({.count = 20}, source);
    touched += expect_brute_surface(tests::mapped(soup, scale, offset), 12);
    const Mesh solid = tests::mapped(tests::make_sphere(1, 2, 4), 1, source.vector(-1, 1));
    inside += expect_brute_solid(tests::mapped(solid, scale, offset), 8);
  }
  EXPECT_GT(touched, 500u);
  EXPECT_GT(inside, 200u);
}

TEST(Law9Voxels, DegenerateMeshes) {
  const std::vector<Eigen::Vector3d> vertices{{1, 2, 3}, {2, 4, 6}, {1, 2, 3}};
  const std::vector<TriangleIndices> point{{0, 2, 0}};
  const std::vector<TriangleIndices> segment{{0, 1, 2}};
  EXPECT_EQ(expect_brute_surface(Mesh(vertices, point), 50), 1u);
  EXPECT_EQ(find_voxels(Mesh(vertices, point), {.resolution = 9, .fill = VoxelFill::Solid}).size(),
            1u);
  for (std::uint32_t resolution = 1; resolution < 20; ++resolution)
    expect_brute_surface(Mesh(vertices, segment), resolution);
  // A flat mesh: one layer.
  const Voxels row = find_voxels(tests::make_row(3), {.resolution = 42});
  EXPECT_EQ(row.grid.counts[2], 1u);
  expect_brute_surface(tests::make_row(3), 42);
}

TEST(Law9Voxels, ABallHasItsVolumeAndItsLayers) {
  const Mesh ball = tests::make_sphere(1, 40, 60);
  const Voxels surface = find_voxels(ball, {.resolution = 100});
  const Voxels solid = find_voxels(ball, {.resolution = 100, .fill = VoxelFill::Solid});
  EXPECT_TRUE(std::includes(solid.begin(), solid.end(), surface.begin(), surface.end()));
  EXPECT_TRUE(std::is_sorted(solid.begin(), solid.end()));
  EXPECT_EQ(std::adjacent_find(solid.begin(), solid.end()), solid.end());
  const double cell = std::pow(solid.grid.edge, 3);
  const double volume = 4.18879;
  EXPECT_GT(static_cast<double>(solid.size()) * cell, 0.99 * volume);
  EXPECT_LT(static_cast<double>(solid.size() - surface.size()) * cell, volume);
}

TEST(Law8Voxels, OrderAndOrientationOfTrianglesChangeNothing) {
  RandomSource source(5);
  const Mesh mesh = tests::random_tetrahedra(6, 1, source);
  std::vector<TriangleIndices> triangles(mesh.triangles().rbegin(), mesh.triangles().rend());
  for (TriangleIndices& t : triangles)
    std::swap(t[0], t[2]);
  const VoxelSettings settings{.resolution = 60, .fill = VoxelFill::Solid};
  EXPECT_EQ(find_voxels(mesh, settings).voxels,
            find_voxels(Mesh(mesh.vertices(), triangles), settings).voxels);
}

TEST(Law8Voxels, AnyNumberOfThreadsFindsTheSame) {
  const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
  const Mesh torus = tests::make_torus(1, 0.3, 50, 30);
  for (VoxelFill fill : {VoxelFill::Surface, VoxelFill::Solid}) {
    const Voxels one = find_voxels(torus, {.resolution = 120, .fill = fill, .threads = 1});
    EXPECT_GT(one.size(), 20000u);
    for (int threads : {0, 2, 4}) {
      const Voxels many = find_voxels(torus, {.resolution = 120, .fill = fill, .threads = threads});
      EXPECT_EQ(many.voxels, one.voxels) << threads;
    }
  }
}

// Law 6: the rounded stage decides nearly all of a mesh in general position; the exact one what
// lies on faces.
TEST(Voxels, WorkSaysWhichStageDecided) {
  Work general, aligned;
  RandomSource source(6);
  find_voxels(tests::random_soup({.count = 200}, source), {.resolution = 50}, &general);
  EXPECT_GT(general.triangle_tests, 10000u);
  EXPECT_EQ(general.trees_built, 1u);
  EXPECT_GT(general.volume_rejections, 0u);
  EXPECT_LT(general.exact_tests * 100, general.triangle_tests);
  find_voxels(tests::make_box({1, 1, 1}), {.resolution = 16}, &aligned);
  EXPECT_GT(aligned.exact_tests, 100u);
}

// The cost follows the surface: twice the resolution, four times the work, not eight.
TEST(Voxels, WorkFollowsTheSurface) {
  const Mesh torus = tests::make_torus(1, 0.3, 20, 12);
  Work coarse, fine;
  find_voxels(torus, {.resolution = 64, .fill = VoxelFill::Solid}, &coarse);
  find_voxels(torus, {.resolution = 128, .fill = VoxelFill::Solid}, &fine);
  EXPECT_LT(fine.triangle_tests, 5 * coarse.triangle_tests);
}

TEST(Voxels, ProgressReachesItsTotal) {
  const Mesh torus = tests::make_torus(1, 0.3, 20, 12);
  std::size_t last = 0, total = 0;
  VoxelSettings settings{.resolution = 100};
  settings.on_progress = [&](std::size_t done, std::size_t of) {
    EXPECT_EQ(done, last + 1);
    last = done;
    total = of;
  };
  find_voxels(torus, settings);
  EXPECT_GT(total, 1u);
  EXPECT_EQ(last, total);
  settings.on_progress = [](std::size_t, std::size_t) { throw std::runtime_error("enough"); };
  EXPECT_THROW(find_voxels(torus, settings), std::runtime_error);
}

// Nobody has walked the mesh yet: one thread builds what all need.
TEST(VoxelsThreads, ManyMayAskAtOnce) {
  const Mesh torus = tests::make_torus(1, 0.3, 40, 20);
  std::vector<Voxels> found(4);
  std::vector<std::thread> threads;
  for (Voxels& voxels : found) {
    threads.emplace_back(
        [&] { voxels = find_voxels(torus, {.resolution = 40, .fill = VoxelFill::Solid}); });
  }
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_GT(found[0].size(), 1000u);
  for (const Voxels& voxels : found)
    EXPECT_EQ(voxels.voxels, found[0].voxels);
}

TEST(Law10Voxels, TooManyVoxelsAreRefused) {
  const Mesh torus = tests::make_torus(1, 0.3, 20, 12);
  for (VoxelFill fill : {VoxelFill::Surface, VoxelFill::Solid}) {
    const std::uint64_t count = find_voxels(torus, {.resolution = 60, .fill = fill}).size();
    EXPECT_NO_THROW(find_voxels(torus, {.resolution = 60, .fill = fill, .max_voxels = count}));
    try {
      find_voxels(torus, {.resolution = 60, .fill = fill, .max_voxels = count - 1});
      FAIL();
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(),
                "resolution: 60 gives more than " + std::to_string(count - 1) + " voxels");
    }
  }
}

TEST(Law10Voxels, BadInputIsRefused) {
  const Mesh box = tests::make_box({1, 1, 1});
  EXPECT_THROW(find_voxels(box, {.resolution = 0}), InputError);
  EXPECT_THROW(find_voxels(box, {.resolution = 65536}), InputError);
  EXPECT_THROW(find_voxels(box, {.threads = -1}), InputError);
  EXPECT_THROW(find_voxels(tests::make_row(1), {.fill = VoxelFill::Solid}), MeshError);
  EXPECT_THROW(find_voxels(tests::make_box({1.7e308, 1, 1})), InputError);
}

}  // namespace
}  // namespace graze

// What write_voxels() writes, read again, and what it refuses.

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/write_voxels.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "tests/files/temporary_directory.h"
#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/formula_meshes.h"

namespace graze {
namespace {

using tests::TemporaryDirectory;

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Twelve triangles in a row are the box of one voxel, looking outward.
void expect_boxes(const Mesh& mesh, const Voxels& voxels) {
  ASSERT_EQ(mesh.triangles().size(), 12 * voxels.size());
  for (std::size_t n = 0; n < voxels.size(); ++n) {
    const Aabb expected = voxels.grid.box(voxels.voxels[n]);
    Eigen::Vector3d low = mesh.triangle(12 * n).a, high = low;
    double volume = 0;  // six times the enclosed, positive if the faces look outward
    for (std::size_t t = 12 * n; t < 12 * n + 12; ++t) {
      const Triangle corners = mesh.triangle(t);
      for (const Eigen::Vector3d& p : {corners.a, corners.b, corners.c}) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
      volume += (corners.a - expected.min)
                    .dot((corners.b - expected.min).cross(corners.c - expected.min));
    }
    ASSERT_EQ(low, expected.min) << n;
    ASSERT_EQ(high, expected.max) << n;
    const double box = (high - low).prod();
    ASSERT_NEAR(volume / 6 / box, 1, 1e-9) << n;
  }
}

void expect_corners_shared(const Mesh& mesh) {
  EXPECT_EQ(mesh.topology().welded_vertices, mesh.vertices().size());
  EXPECT_TRUE(mesh.topology().is_closed);
}

TEST(WriteVoxels, BothFormatsLoadAgainAsTheSameBoxes) {
  const TemporaryDirectory directory;
  RandomSource source(1);
  for (int n = 0; n < 10; ++n) {
    const Eigen::Vector3d offset = source.vector(-1, 1) * (n % 3 == 0 ? 1e3 : 0);
    const Mesh mesh = tests::mapped(tests::random_tetrahedra(1, 1, source), 1, offset);
    const auto resolution = static_cast<std::uint32_t>(1 + n * 3);
    const Voxels voxels = find_voxels(
        mesh,
        {.resolution = resolution, .fill = n % 2 == 0 ? VoxelFill::Surface : VoxelFill::Solid});
    write_voxels(directory.path("a.obj"), voxels);
    write_voxels(directory.path("a.PLY"), voxels);
    const Mesh obj = load_mesh(directory.path("a.obj"));
    const Mesh ply = load_mesh(directory.path("a.PLY"));
    expect_boxes(obj, voxels);
    expect_corners_shared(obj);
    EXPECT_TRUE(std::ranges::equal(obj.vertices(), ply.vertices()));
    EXPECT_TRUE(std::ranges::equal(obj.triangles(), ply.triangles()));
  }
}

TEST(WriteVoxels, ExtremeNumbersSurvive) {
  const TemporaryDirectory directory;
  for (double scale : {1e-300, 1e300}) {
    const Mesh box = tests::mapped(tests::make_box({1, 1, 1}), scale, Eigen::Vector3d::Zero());
    const Voxels voxels = find_voxels(box, {.resolution = 3});
    for (const char* name : {"a.obj", "a.ply"}) {
      write_voxels(directory.path(name), voxels);
      const Mesh loaded = load_mesh(directory.path(name));
      EXPECT_EQ(loaded.bounds().min, voxels.grid.box({0, 0, 0}).min);
      EXPECT_EQ(loaded.bounds().max, voxels.grid.box({2, 2, 2}).max);
      EXPECT_EQ(loaded.vertices().size(), 64u);
    }
  }
}

TEST(WriteVoxels, OneVoxelAsText) {
  const TemporaryDirectory directory;
  const Voxels one{{{0, 0.1, -1}, 1, {1, 1, 1}}, {{0, 0, 0}}};
  write_voxels(directory.path("one.obj"), one);
  EXPECT_EQ(bytes_of(directory.path("one.obj")),
            "# voxels, metres\n"
            "v 0 0.10000000000000001 -1\nv 1 0.10000000000000001 -1\n"
            "v 0 1.1000000000000001 -1\nv 1 1.1000000000000001 -1\n"
            "v 0 0.10000000000000001 0\nv 1 0.10000000000000001 0\n"
            "v 0 1.1000000000000001 0\nv 1 1.1000000000000001 0\n"
            "f 1 5 7 3\nf 2 4 8 6\nf 1 2 6 5\nf 3 7 8 4\nf 1 3 4 2\nf 5 6 8 7\n");
}

TEST(WriteVoxels, TheLastVoxelOfTheLargestGrid) {
  const TemporaryDirectory directory;
  const Voxels far{{{0, 0, 0}, 1, {65535, 65535, 65535}},
                   {{65534, 0, 0}, {0, 65534, 65534}, {65534, 65534, 65534}}};
  write_voxels(directory.path("far.ply"), far);
  expect_boxes(load_mesh(directory.path("far.ply")), far);
}

TEST(WriteVoxels, ProgressReachesItsTotal) {
  const TemporaryDirectory directory;
  const Voxels voxels = find_voxels(tests::make_sphere(1, 20, 20), {.resolution = 60});
  std::uint64_t last = 0, total = 0, calls = 0;
  write_voxels(directory.path("a.ply"), voxels,
               {.on_progress = [&](std::uint64_t done, std::uint64_t of) {
                 EXPECT_GT(done, last);
                 last = done;
                 total = of;
                 ++calls;
               }});
  EXPECT_GT(calls, 1u);
  EXPECT_EQ(last, total);
  const auto stop = [](std::uint64_t, std::uint64_t) { throw std::runtime_error("enough"); };
  EXPECT_THROW(write_voxels(directory.path("b.ply"), voxels, {.on_progress = stop}),
               std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(directory.path("b.ply")));
  const auto size = std::filesystem::file_size(directory.path("a.ply"));
  EXPECT_THROW(write_voxels(directory.path("a.ply"), voxels, {.on_progress = stop}),
               std::runtime_error);
  EXPECT_EQ(std::filesystem::file_size(directory.path("a.ply")), size) << "the old one stays";
  const std::filesystem::directory_iterator files(directory.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "and nothing else";
}

class WriteVoxelsErrors : public testing::Test {
 protected:
  std::string error_of(const std::string& name) const {
    const std::string path = directory_.path(name);
    try {
      write_voxels(path, voxels_);
    } catch (const MeshError& error) {
      const std::string what = error.what();
      EXPECT_TRUE(what.starts_with(path)) << what;
      return what.substr(path.size());
    }
    return {};
  }

  const TemporaryDirectory directory_;
  const Voxels voxels_ = find_voxels(tests::make_box({1, 1, 1}), {.resolution = 40});
};

TEST_F(WriteVoxelsErrors, OtherEndingsAreRefused) {
  EXPECT_EQ(error_of("a.stl"), ": unknown extension \".stl\", voxels are written to .obj .ply");
  EXPECT_EQ(error_of("a"), ": no extension, voxels are written to .obj .ply");
  EXPECT_FALSE(std::filesystem::exists(directory_.path("a.stl")));
}

TEST_F(WriteVoxelsErrors, WhatCannotBeOpenedIsNamed) {
  EXPECT_EQ(error_of("missing/a.obj"), ": cannot be written: No such file or directory");
  std::filesystem::create_directory(directory_.path("folder.ply"));
  EXPECT_EQ(error_of("folder.ply"), ": cannot be written: Is a directory");
  EXPECT_TRUE(std::filesystem::exists(directory_.path("folder.ply")));
}

TEST_F(WriteVoxelsErrors, AFullDiskIsAnErrorAndDevicesStay) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  std::filesystem::create_symlink("/dev/full", directory_.path("full.ply"));
  EXPECT_EQ(error_of("full.ply"), ": cannot be written: No space left on device");
  EXPECT_TRUE(std::filesystem::is_symlink(directory_.path("full.ply")));
  EXPECT_TRUE(std::filesystem::exists("/dev/full"));
}

TEST_F(WriteVoxelsErrors, VoxelsThatAreNoneAreRefusedBeforeTheFileIsTouched) {
  const std::string path = directory_.write("a.obj", "old");
  const VoxelGrid grid{{0, 0, 0}, 1, {2, 2, 2}};
  EXPECT_THROW(write_voxels(path, {grid, {}}), InputError);
  EXPECT_THROW(write_voxels(path, {grid, {{0, 2, 0}}}), InputError);
  EXPECT_THROW(write_voxels(path, {grid, {{1, 0, 0}, {1, 0, 0}}}), InputError);
  EXPECT_THROW(write_voxels(path, {grid, {{1, 0, 0}, {0, 0, 0}}}), InputError);
  EXPECT_THROW(write_voxels(path, {{{0, 0, 0}, 0, {2, 2, 2}}, {{0, 0, 0}}}), InputError);
  EXPECT_EQ(bytes_of(path), "old");
}

}  // namespace
}  // namespace graze

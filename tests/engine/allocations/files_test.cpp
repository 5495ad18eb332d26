// Files that are read and written while allocations fail: std::bad_alloc comes out, nothing is
// leaked, no temporary file is left, and an old file stays as it was.

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/voxels.h>
#include <graze/engine/mesh/write_voxels.h>
#include <graze/engine/pose_text.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/engine/allocations/fail_each_allocation.h"
#include "tests/files/temporary_directory.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {
namespace {

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

const char kTriangle[] =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n";
const char kObj[] =
    "# a comment\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf -1/1/1 -2// -3\n";
const char kStl[] =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid s\n";
const char kPly[] =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 "
    "1 2\n";

TEST(Allocations, OfMeshFilesMayFail) {
  const TemporaryDirectory folder;
  for (const auto& [name, bytes] : {std::pair("a.off", kTriangle), std::pair("a.obj", kObj),
                                    std::pair("a.stl", kStl), std::pair("a.ply", kPly)}) {
    const std::string path = folder.write(name, bytes);
    std::size_t triangles = load_mesh(path).triangles().size(), loaded = 0;
    fail_each_allocation_of_files(
        name, [&] { loaded = load_mesh(path).triangles().size(); },
        [&](const Attempt&) { EXPECT_EQ(loaded, triangles); });
  }
}

TEST(Allocations, OfPosesMayFail) {
  const TemporaryDirectory folder;
  const std::string path =
      folder.write("poses.txt", "1 0 0 0  0 1 0 0  0 0 1 0.002\n1 0 0 1  0 1 0 2  0 0 1 3\n");
  fail_each_allocation_of_files(
      "poses", [&] { EXPECT_EQ(load_poses(path).size(), 2u); }, [](const Attempt&) {});
}

TEST(Allocations, OfWrittenVoxelsMayFail) {
  const TemporaryDirectory folder;
  const Voxels voxels = find_voxels(make_sphere(1, 8, 8), {.resolution = 12});
  for (const char* name : {"voxels.ply", "voxels.obj"}) {
    const std::string path = folder.path(name);
    write_voxels(path, voxels);
    const std::string expected = bytes_of(path), old = "what was there before\n";
    fail_each_allocation_of_files(
        name, [&] { write_voxels(path, voxels); },
        [&](const Attempt& made) {
          EXPECT_TRUE(bytes_of(path) == (made.has_ended ? expected : old));
          EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
        },
        [&] { folder.write(name, old); });
    std::filesystem::remove(path);
  }
}

}  // namespace
}  // namespace graze::tests

// What a mesh needs to be asked for pairs, while its tree is built and afterwards.

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/prepare.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <string>

#include "tests/engine/body_world/allocations.h"
#include "tests/shapes/formula_meshes.h"

namespace graze {
namespace {

struct BytesPerTriangle {
  double afterwards;
  double at_most;
};

BytesPerTriangle bytes_of_building(const Mesh& mesh) {
  // Each thread builds a part of two thousand triangles at a time.
  const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
  const auto before = static_cast<double>(tests::allocated_bytes());
  tests::most_allocated_bytes();
  prepare(mesh);
  const auto count = static_cast<double>(mesh.triangles().size());
  return {(static_cast<double>(tests::allocated_bytes()) - before) / count,
          (static_cast<double>(tests::most_allocated_bytes()) - before) / count};
}

TEST(BuildingMemory, TreesTakeAtMostSixtyBytesATriangle) {
  for (const char* name :
       {"bolt.obj", "gear.ply", "link.ply", "nut.stl", "pinion.off", "rock.ply", "terrain.ply"}) {
    const Mesh mesh = load_mesh(std::string(GRAZE_DATA_DIR "/meshes/") + name);
    const BytesPerTriangle bytes = bytes_of_building(mesh);
    EXPECT_LE(bytes.afterwards, 60) << name;
    EXPECT_GE(bytes.afterwards, 40) << name << ": corners and places alone take as much";
  }
}

TEST(BuildingMemory, LittleMoreIsNeededMeanwhile) {
  const Mesh mesh = tests::make_sphere(1, 200, 200);
  ASSERT_GT(mesh.triangles().size(), 79000u);
  const BytesPerTriangle bytes = bytes_of_building(mesh);
  EXPECT_LE(bytes.afterwards, 60);
  EXPECT_LE(bytes.at_most, 64);
  EXPECT_GE(bytes.at_most, bytes.afterwards);
}

}  // namespace
}  // namespace graze

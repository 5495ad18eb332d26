// Voxels: those that a mesh touches, those that it encloses, and files of them.

#include <filesystem>

#include "samples/examples/example.h"

using examples::expect;

int main(int argc, char** argv) {
  if (argc != 2) return 2;  // a folder to write to
  const graze::Mesh cube = examples::cube(1);
  const graze::Voxels surface = graze::find_voxels({cube}, {.resolution = 4});
  const graze::Voxels solid =
      graze::find_voxels({cube}, {.resolution = 4, .fill = graze::VoxelFill::Solid});
  expect(solid.size() == 64 && surface.size() == 64 - 8, "all but the inner 2 x 2 x 2");

  const graze::VoxelGrid& grid = solid.grid;
  expect(grid.edge == 0.25 && grid.size() == 64, "4 x 4 x 4 cubes");
  expect(grid.plane(0, 4) == 1, "the last plane along x");
  expect(grid.box(solid.voxels.front()).max == Eigen::Vector3d(0.25, 0.25, 0.25), "the first cube");
  const graze::VoxelGrid own = graze::VoxelGrid::over({{0, 0, 0}, {2, 1, 1}}, 8);
  own.check();  // throws InputError for a grid that cannot be
  expect(own.counts == std::array<std::uint32_t, 3>{8, 4, 4}, "a grid over any box");

  const std::filesystem::path file = std::filesystem::path(argv[1]) / "voxels.ply";
  graze::write_voxels(file, surface);
  expect(graze::load_mesh(file).triangles().size() == 12 * surface.size(), "12 triangles a voxel");
  std::filesystem::remove(file);
}

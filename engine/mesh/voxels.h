#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/mesh/voxel_grid.h>
#include <graze/engine/work.h>

namespace graze {

/// The voxels that may be asked for.
enum class VoxelFill {
  Surface,  ///< the voxels that share a point with a triangle
  Solid,    ///< these, and all that lie inside a closed mesh
};

/// The settings of find_voxels().
struct VoxelSettings {
  /// The number of voxels along the longest side of the mesh's bounds, 1 to 65535; see
  /// VoxelGrid::over().
  std::uint32_t resolution = 64;
  VoxelFill fill = VoxelFill::Surface;  ///< the surface alone, or what it encloses, too
  /// The number of threads that share the work at most; 0 means all that there are.
  int threads = 1;
  /// More voxels than this are an error, found before they fill the memory. Which resolution is too
  /// high does not depend on threads.
  std::uint64_t max_voxels = std::numeric_limits<std::uint64_t>::max();
  /// If set, called as work goes on with how many of how many parts are done, by one thread at a
  /// time. What it throws ends the query.
  std::function<void(std::size_t done, std::size_t total)> on_progress = {};
};

/// The voxels of a grid in ascending order, each once.
struct Voxels {
  VoxelGrid grid;             ///< the grid in which they lie
  std::vector<Voxel> voxels;  ///< ascending

  std::size_t size() const { return voxels.size(); }
  bool empty() const { return voxels.empty(); }
  auto begin() const { return voxels.begin(); }
  auto end() const { return voxels.end(); }

  bool operator==(const Voxels&) const = default;
};

/// Returns all voxels of the common frame that the placed mesh's surface touches (law 1), exactly
/// (law 3: closed boxes, closed triangles), or those of the solid. In a solid, a voxel that touches
/// no triangle is inside if its points are enclosed as contains() says. The result is the same for
/// any number of threads. The time follows the surface, not the volume: blocks of voxels that no
/// triangle touches are decided as a whole. Throws InputError as VoxelGrid::over() does for bad
/// settings and for more than max_voxels, MeshError for the solid of a mesh that is not closed, and
/// PoseError for a pose that is refused by law 10 or by law 1. A mesh in any other pose than the
/// identity is placed as a whole, and its tree fitted to where it is, which takes O(n) time and
/// memory.
Voxels find_voxels(const PlacedMeshView& mesh, const VoxelSettings& settings = {},
                   Work* work = nullptr);

}  // namespace graze

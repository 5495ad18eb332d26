#pragma once

// These are the planes of a grid, computed once per query. They are private to engine/mesh.

#include <graze/bvh/value/float_box.h>
#include <graze/bvh/value/local_frame.h>
#include <graze/engine/mesh/voxel_grid.h>

#include <array>
#include <cstdint>
#include <vector>

namespace graze {

/// The voxels with indices from `first` up to but without `last`, along each axis.
struct VoxelBlock {
  std::array<std::uint32_t, 3> first;
  std::array<std::uint32_t, 3> last;

  std::uint32_t length(int axis) const { return last[axis] - first[axis]; }
  std::uint64_t size() const { return std::uint64_t{length(0)} * length(1) * length(2); }
  int longest_axis() const;
};

/// The planes of a grid over a mesh, as doubles and in the local frame of its tree.
class VoxelPlanes {
 public:
  VoxelPlanes(const VoxelGrid& grid, const bvh::LocalFrame& frame, const Aabb& bounds);

  /// Returns the closed box of a block.
  Aabb box(const VoxelBlock& block) const;

  /// Returns the part of that box which can hold a point of the mesh, rounded outward.
  bvh::FloatBox local_box(const VoxelBlock& block) const;

  /// Returns the corner of a block with the smallest coordinates.
  Eigen::Vector3d first_corner(const VoxelBlock& block) const;

  /// Returns the same corner, rounded outward.
  bvh::FloatBox local_first_corner(const VoxelBlock& block) const;

 private:
  struct Plane {
    double at;
    float local_below;
    float local_above;
  };
  std::array<std::vector<Plane>, 3> planes_;
};

}  // namespace graze

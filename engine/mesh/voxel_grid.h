#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/hash.h>
#include <Eigen/Core>
#include <array>
#include <compare>
#include <cstdint>
#include <functional>

namespace graze {

/// The indices of a voxel along x, y and z. Voxels are ordered by k, then j, then i: a row along x
/// is contiguous.
struct Voxel {
  std::uint16_t i;  ///< along x
  std::uint16_t j;  ///< along y
  std::uint16_t k;  ///< along z

  friend bool operator==(const Voxel&, const Voxel&) = default;
  friend std::strong_ordering operator<=>(const Voxel& a, const Voxel& b) {
    return a.key() <=> b.key();
  }

 private:
  constexpr std::uint64_t key() const {
    return static_cast<std::uint64_t>(k) << 32 | static_cast<std::uint64_t>(j) << 16 | i;
  }
};

/// Cubes side by side. The planes between them decide: voxel (i, j, k) is the closed box between
/// planes i and i + 1 along x, and so on, so that neighbours share a face bit for bit.
struct VoxelGrid {
  Eigen::Vector3d origin;               ///< metres, the corner with the smallest coordinates
  double edge;                          ///< metres, the length of a voxel's edges, above 0
  std::array<std::uint32_t, 3> counts;  ///< the numbers of voxels along x, y and z, from 1 to 65535

  /// Returns the grid over a box: from its minimum up to the first plane at or beyond its maximum,
  /// along each axis. The longest side has `resolution` voxels. The edge is that side / resolution,
  /// rounded up to 36 significant bits, so that index * edge is exact and planes carry one rounding
  /// alone; and at least 2^-50 of the largest coordinate, so that planes are distinct. Where that
  /// is more than the side would ask for, as in a box that is a point, there are fewer voxels.
  /// Throws InputError for an invalid box, a resolution that is not from 1 to 65535, or a plane
  /// that would overflow.
  static VoxelGrid over(const Aabb& bounds, std::uint32_t resolution);

  /// Returns origin + index * edge, rounded once, metres. `index` is at most the count along the
  /// axis.
  double plane(int axis, std::uint32_t index) const;

  /// Returns the closed box between the voxel's six planes.
  Aabb box(const Voxel& voxel) const;

  /// Throws InputError unless there are 1 to 65535 voxels along each axis and planes are finite and
  /// rise. Grids made by over() pass.
  void check() const;

  /// Returns the number of all voxels, of which a mesh touches some.
  std::uint64_t size() const;

  bool operator==(const VoxelGrid&) const = default;
};

}  // namespace graze

template <>
struct std::hash<graze::Voxel> {
  std::size_t operator()(const graze::Voxel& voxel) const noexcept {
    return graze::hash_of({voxel.i, voxel.j, voxel.k});
  }
};

#pragma once

#include <graze/engine/mesh/voxels.h>
#include <array>
#include <cstdint>
#include <vector>

namespace graze::mesh_io {

/// The corners of voxels, each once, numbered from 0 in ascending order of their planes along z,
/// then y, then x.
class VoxelCorners {
 public:
  /// Takes voxels, which must be in order, each once, and within their grid.
  explicit VoxelCorners(const Voxels& voxels);

  std::uint64_t size() const { return keys_.size(); }

  /// Calls `corner_fn({i, j, k})`, numbers of planes, for each corner in order.
  template <typename CornerFn>
  void for_each(CornerFn&& corner_fn) const {
    for (std::uint32_t k = 0; k + 1 < first_.size(); ++k) {
      for (std::uint64_t n = first_[k]; n < first_[k + 1]; ++n) {
        corner_fn(std::array<std::uint32_t, 3>{keys_[n] & 0xffff, keys_[n] >> 16, k});
      }
    }
  }

  /// Returns the number of the corner in planes i, j and k, which must be one.
  std::uint64_t number(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;

 private:
  std::vector<std::uint32_t> keys_;   ///< j and i, 16 bits each, layer by layer
  std::vector<std::uint64_t> first_;  ///< where in keys_ each plane along z begins, and the end
};

/// Gives the numbers of the eight corners of voxels in order, corner x + 2 y + 4 z for x, y, z in
/// {0, 1}.
class VoxelCornerNumbers {
 public:
  explicit VoxelCornerNumbers(const VoxelCorners& corners) : corners_(corners) {}

  const std::array<std::uint64_t, 8>& of(const Voxel& voxel);

 private:
  const VoxelCorners& corners_;
  Voxel last_{};
  bool has_last_ = false;
  std::array<std::uint64_t, 8> numbers_{};
};

}  // namespace graze::mesh_io

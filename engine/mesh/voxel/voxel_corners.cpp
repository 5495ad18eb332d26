#include <graze/engine/mesh/voxel/voxel_corners.h>
#include <algorithm>
#include <iterator>
#include <span>

namespace graze::mesh_io {
namespace {

/// Returns the key of two numbers of planes. They have 16 bits: grids have at most 65535 voxels
/// along an axis.
constexpr std::uint32_t key_of(std::uint32_t i, std::uint32_t j) {
  return j << 16 | i;
}

void append_corners(std::span<const Voxel> layer, std::vector<std::uint32_t>& keys) {
  for (const Voxel& voxel : layer) {
    keys.insert(keys.end(), {key_of(voxel.i, voxel.j), key_of(voxel.i + 1u, voxel.j),
                             key_of(voxel.i, voxel.j + 1u), key_of(voxel.i + 1u, voxel.j + 1u)});
  }
}

/// Takes off the voxels of layer k, which come first among those of this and later layers, and
/// returns them.
std::span<const Voxel> take_layer(std::span<const Voxel>& voxels, std::uint32_t k) {
  const auto is_of_layer = [&](const Voxel& voxel) { return voxel.k == k; };
  const auto end = std::partition_point(voxels.begin(), voxels.end(), is_of_layer);
  const auto layer = voxels.first(static_cast<std::size_t>(end - voxels.begin()));
  voxels = voxels.subspan(layer.size());
  return layer;
}

}  // namespace

VoxelCorners::VoxelCorners(const Voxels& voxels) {
  std::vector<std::uint32_t> layer_keys;
  std::span<const Voxel> left = voxels.voxels;
  std::span<const Voxel> below;
  for (std::uint32_t k = 0; k <= voxels.grid.counts[2]; ++k) {
    const std::span<const Voxel> above = take_layer(left, k);
    layer_keys.clear();
    append_corners(below, layer_keys);
    append_corners(above, layer_keys);
    std::sort(layer_keys.begin(), layer_keys.end());
    first_.push_back(keys_.size());
    std::unique_copy(layer_keys.begin(), layer_keys.end(), std::back_inserter(keys_));
    below = above;
  }
  first_.push_back(keys_.size());
}

std::uint64_t VoxelCorners::number(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  const auto begin = keys_.begin();
  const auto found =
      std::lower_bound(begin + static_cast<std::ptrdiff_t>(first_[k]),
                       begin + static_cast<std::ptrdiff_t>(first_[k + 1]), key_of(i, j));
  return static_cast<std::uint64_t>(found - begin);
}

// Along a row corners follow one another, and so do their numbers.
const std::array<std::uint64_t, 8>& VoxelCornerNumbers::of(const Voxel& voxel) {
  if (has_last_ && last_.i + 1 == voxel.i && last_.j == voxel.j && last_.k == voxel.k) {
    for (std::uint64_t& number : numbers_)
      ++number;
  } else {
    for (std::uint32_t edge = 0; edge < 4; ++edge) {
      numbers_[2 * edge] = corners_.number(voxel.i, voxel.j + edge % 2, voxel.k + edge / 2);
      numbers_[2 * edge + 1] = numbers_[2 * edge] + 1;
    }
  }
  last_ = voxel;
  has_last_ = true;
  return numbers_;
}

}  // namespace graze::mesh_io

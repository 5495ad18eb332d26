#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/voxels.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/shape.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace graze {

/// The set of full voxels of a grid, so that an occupancy map, such as the leaves of an octree, can
/// be one body. It is a value; voxels are added and removed one by one or as blocks. They are kept
/// in blocks of 16 x 16 x 16, at most 2^20 of them. Whatever is in it, a block takes 600 to 1,200
/// bytes, and in a body up to 850 more: this is 3 to 8 bytes for each voxel of a surface, and some
/// 0.2 where all voxels are full.
class VoxelMap {
 public:
  /// The number of voxels that a stored block has along each side.
  static constexpr std::uint32_t kBlock = 16;

  /// Makes a map without voxels. Throws InputError as VoxelGrid::check() does.
  explicit VoxelMap(const VoxelGrid& grid);
  /// Makes a map of voxels that have been found, such as those of a mesh.
  explicit VoxelMap(const Voxels& voxels);

  /// Add voxels that are not yet full, or remove those that are; the others stay as they are. They
  /// throw InputError for a voxel outside the grid, and then change nothing. They also throw at the
  /// first voxel that needs more than 2^20 blocks, or more memory than there is: all before it are
  /// then done, and the call can be repeated. They cost O(n).
  void add(std::span<const Voxel> voxels);
  void remove(std::span<const Voxel> voxels);
  /// Add or remove all voxels from `first` to `last`, both included, along each axis, such as a
  /// leaf of an octree. They throw as add() does, and if `last` is before `first`. They cost
  /// O(blocks that are met).
  void add_block(const Voxel& first, const Voxel& last);
  void remove_block(const Voxel& first, const Voxel& last);

  bool contains(const Voxel& voxel) const;         ///< true if the voxel is full
  std::size_t size() const { return size_; }       ///< the number of full voxels
  bool empty() const { return size_ == 0; }        ///< true if no voxel is full
  const VoxelGrid& grid() const { return grid_; }  ///< the grid of the voxels
  std::vector<Voxel> voxels() const;               ///< the full voxels, ascending

  /// Return the number by which contacts, rays and queries know a voxel, and the voxel of such a
  /// number. A number stays as long as the voxel does. They throw StaleIdError for a voxel that is
  /// not full.
  std::uint32_t part(const Voxel& voxel) const;
  Voxel voxel(std::uint32_t part) const;
  /// Returns the pose of a full voxel in the map's frame: its middle is (origin + index edge) +
  /// edge / 2, each operation rounded. The shape of the voxel is box().
  Pose pose(std::uint32_t part) const;
  /// Returns the shape of each voxel, a box with half the edge as its half extent along each axis.
  Shape box() const;

 private:
  friend class VoxelBody;
  /// One row of bits along x for each y and z, y after y and then z after z.
  using Rows = std::array<std::uint16_t, kBlock * kBlock>;
  struct Block {
    std::uint64_t key = 0;    ///< the place of the block in the grid
    std::uint32_t count = 0;  ///< the number of full voxels, 0 in a free block
    Rows rows = {};
  };
  static std::uint64_t key_of(const Voxel& voxel);
  void check(const Voxel& voxel, const char* what) const;
  const Block* find(const Voxel& voxel) const;
  Block& make(const Voxel& voxel);
  void set_row(Block& block, std::uint32_t row, std::uint16_t bits, bool is_full);
  void set_block(const Voxel& first, const Voxel& last, bool is_full, const char* what);

  VoxelGrid grid_;
  std::vector<Block> blocks_;
  std::vector<std::uint32_t> free_;
  std::unordered_map<std::uint64_t, std::uint32_t> places_;  ///< the place in blocks_ of each key
  std::size_t size_ = 0;
};

/// Makes a BodyShape of a map, for World::add() and World::set_shape(). It meets what its voxels
/// would meet as boxes of their own, at the same places and times, each in the pose
/// placed_part(body, pose(part)), as a Compound of these boxes would: contacts, rays and queries
/// name the voxels as parts. A ball that rolls over voxels has a contact with each that it touches.
/// An answer looks at the voxels near the other shape, a ray at the blocks along it, and a distance
/// at the blocks that could hold the nearest voxel, nearest blocks first; where the grid lies in
/// its frame does not matter. The shape holds a copy of the map, which costs O(blocks). Throws
/// InputError for a map without voxels, PoseError for one that reaches beyond kLargestLength.
std::shared_ptr<const BodyShape> share(const VoxelMap& map);

/// Returns the map that a shape stands for, as it was shared, or nullptr.
const VoxelMap* voxel_map_of(const BodyShape& shape);

}  // namespace graze

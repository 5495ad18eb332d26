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

/// Which voxels of a grid are full: what an occupancy map, such as an octree's leaves, becomes to
/// be one body. A value; voxels are added and removed one by one or as blocks. Kept in blocks of 16
/// x 16 x 16, of which each takes 600 to 1,200 bytes and in a body up to 850 more, whatever is in
/// it: 3 to 8 bytes a voxel of a surface, and some 0.2 where all are full. At most 2^20 blocks.
class VoxelMap {
 public:
  /// Voxels along each side of a block that is kept as one.
  static constexpr std::uint32_t kBlock = 16;

  /// Without voxels. Throws InputError as VoxelGrid::check() does.
  explicit VoxelMap(const VoxelGrid& grid);
  /// Those of a mesh, or what else has been found.
  explicit VoxelMap(const Voxels& voxels);

  /// Those that are there, or not, stay as they are. Throws InputError for one that is not of the
  /// grid, and then changes nothing; and at the first that needs more than 2^20 blocks, or memory
  /// that is not there: what comes before it is then done, and all can be asked for again. O(n).
  void add(std::span<const Voxel> voxels);
  void remove(std::span<const Voxel> voxels);
  /// The same of all from `first` to `last`, both included, along each axis, as a leaf of an octree
  /// is. Throws likewise, and if `last` is before `first`. O(blocks that it meets).
  void add_block(const Voxel& first, const Voxel& last);
  void remove_block(const Voxel& first, const Voxel& last);

  bool contains(const Voxel& voxel) const;         ///< whether it is full
  std::size_t size() const { return size_; }       ///< how many are full
  bool empty() const { return size_ == 0; }        ///< whether none is
  const VoxelGrid& grid() const { return grid_; }  ///< in which they lie
  std::vector<Voxel> voxels() const;               ///< ascending

  /// The number by which contacts, rays and queries know a voxel, and back. Numbers stay as long as
  /// the voxel does. Throw StaleIdError for one that is not full.
  std::uint32_t part(const Voxel& voxel) const;
  Voxel voxel(std::uint32_t part) const;
  /// The pose of a full voxel in the map's frame: its middle, (origin + index edge) + edge / 2,
  /// each operation rounded. Its shape is box().
  Pose pose(std::uint32_t part) const;
  /// The shape of each voxel: half the edge along each axis.
  Shape box() const;

 private:
  friend class VoxelBody;
  /// Rows along x, y after y and z after z.
  using Rows = std::array<std::uint16_t, kBlock * kBlock>;
  struct Block {
    std::uint64_t key = 0;    ///< where it is
    std::uint32_t count = 0;  ///< how many are full; none in a block that is free
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
  std::unordered_map<std::uint64_t, std::uint32_t> places_;  ///< of keys
  std::size_t size_ = 0;
};

/// The map as a world asks it, for World::add() and World::set_shape(). What it meets, where and
/// when is what its voxels meet as boxes of their own, each in the pose placed_part(body,
/// pose(part)), as a Compound of these would: contacts, rays and queries name them as parts. A ball
/// that rolls over voxels has a contact with each that it touches. An answer costs the voxels near
/// the other, a ray those of the blocks along it, and a distance the blocks that could hold the
/// nearest, of which the nearest are looked into first; wherever in its frame the grid lies. It
/// holds a copy of the map; O(blocks). Throws InputError for a map without voxels, PoseError for
/// one that reaches beyond kLargestLength.
std::shared_ptr<const BodyShape> share(const VoxelMap& map);

/// The map that a shape stands for, as it was shared, or nullptr.
const VoxelMap* voxel_map_of(const BodyShape& shape);

}  // namespace graze

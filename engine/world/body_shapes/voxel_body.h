#pragma once

// A map of voxels as a world asks it. Private to engine/world.

#include <graze/engine/world/body_shapes/parts_body.h>
#include <graze/engine/world/broad_phase.h>
#include <graze/engine/world/voxel_map.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace graze {

/// Blocks are looked up by boxes around what is full in them, and voxels in a block by their
/// indices.
class VoxelBody final : public PartsBody {
 public:
  /// Throws as share() does.
  explicit VoxelBody(const VoxelMap& map);

  const VoxelMap& map() const { return map_; }

 private:
  OwnPart part(std::uint32_t number) const override;
  std::vector<std::uint32_t> parts_near(const Aabb& own_box) const override;
  std::vector<std::uint32_t> all_parts() const override;
  /// Blocks nearest first, and of these eighths, again and again, down to voxels.
  void look_at_nearest(const std::optional<Aabb>& own_box, const GapToParts& gap, double limit,
                       const Look& look) const override;
  void visit_along(const Ray& own_ray, const Look& look) const override;
  void check_parts(const Pose& pose) const override;

  /// Of a block the voxels from a corner on, `side` along each axis.
  struct BlockCube {
    std::uint32_t x = 0, y = 0, z = 0, side = VoxelMap::kBlock;
  };
  std::optional<Aabb> box_of(const VoxelMap::Block& block, const BlockCube& cube) const;
  static std::uint32_t corner_of(const VoxelMap::Block& block, int axis);
  double look_in_cube(std::uint32_t place, const BlockCube& cube, const GapToParts& gap,
                      double limit, const Look& look) const;
  template <typename Visit>
  void for_voxels_in(std::uint32_t place, const Aabb& own_box, const Visit& visit) const;

  VoxelMap map_;
  std::shared_ptr<const BodyShape> box_;  ///< of each voxel
  BroadPhase blocks_;                     ///< with index_room(), by places in `places_`
  std::vector<std::uint32_t> places_;     ///< of the blocks that are full, ascending
  std::vector<Aabb> boxes_;               ///< of these, around what is full, without room
};

}  // namespace graze

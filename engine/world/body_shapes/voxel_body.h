#pragma once

// The BodyShape of a map of voxels. Private to engine/world.

#include <graze/engine/world/body_shapes/parts_body.h>
#include <graze/engine/world/broad_phase.h>
#include <graze/engine/world/voxel_map.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace graze {

/// A map of voxels as a body of parts. Blocks are looked up by boxes around their full voxels, and
/// voxels in a block by their indices.
class VoxelBody final : public PartsBody {
 public:
  /// Throws as share() does.
  explicit VoxelBody(const VoxelMap& map);

  const VoxelMap& map() const { return map_; }

 private:
  OwnPart part(std::uint32_t number) const override;
  std::vector<std::uint32_t> parts_near(const Aabb& own_box) const override;
  std::vector<std::uint32_t> all_parts() const override;
  /// Looks at blocks, nearest first, and then at their eighths, again and again, down to voxels.
  void look_at_nearest(const std::optional<Aabb>& own_box, const GapToParts& gap, double limit,
                       const Look& look) const override;
  void visit_along(const Ray& own_ray, const Look& look) const override;
  void check_parts(const Pose& pose) const override;

  /// The voxels of a block in a cube from a corner on, `side` of them along each axis.
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
  std::shared_ptr<const BodyShape> box_;  ///< the shape of each voxel
  BroadPhase blocks_;                     ///< the boxes of blocks with index_room(), by places in
                                          ///< `places_`
  std::vector<std::uint32_t> places_;     ///< the places of blocks with full voxels, ascending
  std::vector<Aabb> boxes_;               ///< boxes around the full voxels of these blocks, without
                                          ///< room
};

}  // namespace graze

#pragma once

#include <graze/bvh/skins/float_volumes.h>
#include <graze/bvh/tree/tree.h>
#include <cstddef>
#include <span>
#include <vector>

namespace graze::bvh {

/// Counts the nodes of a tree at one distance from its root, and sums up their volumes. The smaller
/// the sum is, the less empty space they hold beside the same primitives.
struct LevelVolumes {
  std::size_t nodes = 0;
  double volume = 0;  ///< the sum of the volumes, cubic metres
};

// Return one element for each level from the root down, in linear time.
std::vector<LevelVolumes> volumes_by_level(const Tree& tree);
std::vector<LevelVolumes> volumes_by_level(const Tree& tree, std::span<const FloatSphere> skin);
std::vector<LevelVolumes> volumes_by_level(const Tree& tree, std::span<const FloatObb> skin);
std::vector<LevelVolumes> volumes_by_level(const Tree& tree, std::span<const FloatKDop> skin);

}  // namespace graze::bvh

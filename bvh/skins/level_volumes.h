#pragma once

#include <graze/bvh/skins/float_volumes.h>
#include <graze/bvh/tree/tree.h>
#include <cstddef>
#include <span>
#include <vector>

namespace graze::bvh {

/// The nodes of a tree at one distance from its root, and what their volumes sum up to. The less
/// they do, the less empty space they hold beside the same primitives.
struct LevelVolumes {
  std::size_t nodes = 0;
  double volume = 0;  ///< cubic metres
};

// One element for each level from the root down. Linear time.
std::vector<LevelVolumes> volumes_by_level(const Tree& tree);
std::vector<LevelVolumes> volumes_by_level(const Tree& tree, std::span<const FloatSphere> skin);
std::vector<LevelVolumes> volumes_by_level(const Tree& tree, std::span<const FloatObb> skin);
std::vector<LevelVolumes> volumes_by_level(const Tree& tree, std::span<const FloatKDop> skin);

}  // namespace graze::bvh

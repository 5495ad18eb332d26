#include <graze/bvh/fit/measure.h>
#include <graze/bvh/skins/level_volumes.h>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace graze::bvh {
namespace {

double local_volume(const FloatBox& box) {
  double product = 1;
  for (int k = 0; k < 3; ++k)
    product *= double{box.max[k]} - box.min[k];
  return product;
}

double local_volume(const FloatSphere& sphere) {
  return 4.0 / 3 * std::numbers::pi * std::pow(sphere.radius, 3);
}

double local_volume(const FloatObb& box) {
  return 8.0 * box.half[0] * box.half[1] * box.half[2];
}

double local_volume(const FloatKDop& kdop) {
  KDop<18> polytope;
  for (int slab = 0; slab < KDop<18>::kSlabs; ++slab) {
    polytope.min[slab] = kdop.min[slab];
    polytope.max[slab] = kdop.max[slab];
  }
  return volume(polytope);
}

/// Sums `volume_of(node)` over the nodes of each level.
template <typename VolumeOf>
std::vector<LevelVolumes> sums_by_level(const Tree& tree, const VolumeOf& volume_of) {
  std::vector<LevelVolumes> levels;
  std::vector<std::uint32_t> level(tree.nodes.size());
  const double cubic_unit = std::pow(tree.frame.unit(), 3);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {  // children stand behind their parents
    const Node& node = tree.nodes[i];
    if (level[i] == levels.size()) levels.emplace_back();
    levels[level[i]].nodes += 1;
    levels[level[i]].volume += volume_of(i) * cubic_unit;
    if (!node.is_leaf()) level[node.first] = level[node.first + 1] = level[i] + 1;
  }
  return levels;
}

}  // namespace

std::vector<LevelVolumes> volumes_by_level(const Tree& tree) {
  return sums_by_level(tree, [&](std::size_t i) { return local_volume(tree.nodes[i].box); });
}

std::vector<LevelVolumes> volumes_by_level(const Tree& tree, std::span<const FloatSphere> skin) {
  return sums_by_level(tree, [&](std::size_t i) { return local_volume(skin[i]); });
}

std::vector<LevelVolumes> volumes_by_level(const Tree& tree, std::span<const FloatObb> skin) {
  return sums_by_level(tree, [&](std::size_t i) { return local_volume(skin[i]); });
}

std::vector<LevelVolumes> volumes_by_level(const Tree& tree, std::span<const FloatKDop> skin) {
  return sums_by_level(tree, [&](std::size_t i) { return local_volume(skin[i]); });
}

}  // namespace graze::bvh

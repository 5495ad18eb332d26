#pragma once

#include <graze/bvh/skins/level_volumes.h>
#include <graze/bvh/volume.h>
#include <graze/engine/mesh/mesh.h>

#include <cstddef>
#include <vector>

namespace graze::benchmark {

/// What a volume costs a mesh, and how it fits. The cascades are two of these.
struct SkinMeasure {
  Volume volume;
  double build_milliseconds;  ///< of the skin alone, or of the tree for Volume::Aabb; median
  std::size_t bytes;          ///< likewise
  std::vector<bvh::LevelVolumes> levels;
};

/// For boxes, spheres, oriented boxes and k-DOPs.
std::vector<SkinMeasure> measure_skins(const Mesh& mesh, int repetitions);

}  // namespace graze::benchmark

#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>

#include <filesystem>
#include <string>
#include <vector>

namespace graze::stress {

/// Two bundled meshes with a pose of the second in which they are apart, and a coordinate along
/// which moving it brings them together.
struct BundledPair {
  std::string name;
  Mesh mesh_a;
  Mesh mesh_b;
  Pose apart;
  int axis;
  double step;  ///< metres, less than what hides a hit; negative towards smaller coordinates
};

/// Bolt and nut, gear and pinion, two rocks. `data` is the folder of the bundled geometry.
std::vector<BundledPair> bundled_pairs(const std::filesystem::path& data);

}  // namespace graze::stress

#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

namespace graze::generator {

/// Poses of B in A's frame, metres, under the name of the file they go to.
struct PoseList {
  std::string name;
  std::vector<Eigen::Isometry3d> poses;
};

/// The nut on the bolt: turning, cross, deep, apart.
std::vector<PoseList> bolt_nut_poses();

/// The pinion on the gear: mesh, tight, deep, apart.
std::vector<PoseList> gear_pinion_poses();

/// Links of a chain: hanging, near, touch, deep, apart. The rock beside itself: far, near, touch,
/// deep. The rock above the terrain: far, near, touch, deep. The nut and the bolt, the pinion and
/// the gear, turned anyhow: far, near, touch. Found by moving the meshes of the directory, as they
/// were written, towards each other.
std::vector<PoseList> approach_poses(const std::filesystem::path& meshes);

}  // namespace graze::generator

#pragma once

#include <Eigen/Geometry>
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

}  // namespace graze::generator

#pragma once

#include <graze/bvh/pose.h>

namespace graze::tests {

/// Moved there, not turned.
inline Pose at(const Eigen::Vector3d& place) {
  Pose pose = Pose::Identity();
  pose.translation() = place;
  return pose;
}

/// For numbers that are drawn, braces keep their order: at({x, y, z}).
inline Pose at(double x, double y = 0, double z = 0) {
  return at(Eigen::Vector3d(x, y, z));
}

}  // namespace graze::tests

#pragma once

#include <graze/bvh/pose.h>

namespace graze::tests {

/// Moved there, not turned.
inline Pose at(double x, double y = 0, double z = 0) {
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Vector3d(x, y, z);
  return pose;
}

}  // namespace graze::tests

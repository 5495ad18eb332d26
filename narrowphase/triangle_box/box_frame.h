#pragma once

#include <graze/bvh/pose.h>
#include <graze/narrowphase/triangle.h>

// How points come into the frame of an oriented box.

namespace graze::narrowphase {

/// Transforms into the frame of an oriented box as law 3 says, without checking either argument.
Eigen::Vector3d point_into_frame(const Eigen::Vector3d& point, const Pose& frame);
Triangle into_frame(const Triangle& triangle, const Pose& frame);

}  // namespace graze::narrowphase

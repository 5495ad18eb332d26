#pragma once

#include <graze/bvh/pose.h>
#include <graze/narrowphase/triangle.h>

namespace graze::narrowphase {

/// Law 1: ((R_i0 x + R_i1 y) + R_i2 z) + t_i in each coordinate, each operation rounded to double,
/// no fused operations. For those who place much, and do all of it in in_standard_arithmetic().
Eigen::Vector3d place(const Pose& pose, const Eigen::Vector3d& point);
Triangle place(const Pose& pose, const Triangle& triangle);

}  // namespace graze::narrowphase

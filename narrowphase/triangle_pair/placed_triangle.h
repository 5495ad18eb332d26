#pragma once

#include <graze/bvh/pose.h>
#include <graze/narrowphase/triangle.h>

namespace graze::narrowphase {

/// Places points as law 1 says: ((R_i0 x + R_i1 y) + R_i2 z) + t_i in each coordinate, each
/// operation rounded to double, no fused operations. Callers that place many points do all of it in
/// in_standard_arithmetic().
Eigen::Vector3d place(const Pose& pose, const Eigen::Vector3d& point);
Triangle place(const Pose& pose, const Triangle& triangle);

}  // namespace graze::narrowphase

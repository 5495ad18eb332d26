#pragma once

#include <array>

#include <graze/bvh/aabb.h>
#include <graze/bvh/pose.h>
#include <graze/narrowphase/triangle.h>

namespace graze {

/// Places a point, or the corners of a triangle, by law 1: ((R_i0 x + R_i1 y) + R_i2 z) + t_i in
/// each coordinate, each operation rounded to double, no fused operations. What a query decides, it
/// decides for the result of this function.
Eigen::Vector3d place(const Pose& pose, const Eigen::Vector3d& point);
Triangle place(const Pose& pose, const Triangle& triangle);

/// Returns the largest absolute value that each coordinate of a placed point of the box, and every
/// intermediate result of place() on the way to it, can have; infinite if it could overflow.
std::array<double, 3> largest_coordinates(const Pose& pose, const Aabb& bounds);

/// Checks a pose at the door (laws 1 and 10): throws PoseError, which begins with `what`, for a
/// pose that is not rigid or under which a point of the box could overflow. Returns the deviation
/// from a rotation.
double check_placement(const Pose& pose, const Aabb& bounds, const char* what);

}  // namespace graze

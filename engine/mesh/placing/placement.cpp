#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/placing/placement_check.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace graze {

Eigen::Vector3d place(const Pose& pose, const Eigen::Vector3d& point) {
  return bvh::in_standard_arithmetic(
      [&]() -> Eigen::Vector3d { return narrowphase::place(pose, point); });
}

Triangle place(const Pose& pose, const Triangle& triangle) {
  return bvh::in_standard_arithmetic(
      [&]() -> Triangle { return narrowphase::place(pose, triangle); });
}

std::array<double, 3> largest_coordinates(const Pose& pose, const Aabb& bounds) {
  const double* m = pose.data();
  double largest[3];
  for (int k = 0; k < 3; ++k) {
    largest[k] = std::max(std::abs(bounds.min.data()[k]), std::abs(bounds.max.data()[k]));
  }
  // Rounding is monotone: the same operations on absolute values bound all of place()'s.
  std::array<double, 3> placed;
  for (int i = 0; i < 3; ++i) {
    placed[i] = ((std::abs(m[i]) * largest[0] + std::abs(m[4 + i]) * largest[1]) +
                 std::abs(m[8 + i]) * largest[2]) +
                std::abs(m[12 + i]);
  }
  return placed;
}

namespace {

[[noreturn]] void throw_overflow(const std::array<double, 3>& largest, const char* what) {
  const char axis = !std::isfinite(largest[0]) ? 'x' : !std::isfinite(largest[1]) ? 'y' : 'z';
  throw PoseError(std::string(what) + ": coordinate " + axis + " of the mesh could overflow");
}

}  // namespace

double check_placement(const Pose& pose, const Aabb& bounds, const char* what) {
  const bvh::RotationError error(pose);
  if (is_surely_placeable(pose, error, sum_of_sizes(bounds))) return error.largest();
  const double deviation = bvh::check_rigid(pose, what);
  const std::array<double, 3> largest = largest_coordinates(pose, bounds);
  for (const double most : largest) {
    if (!std::isfinite(most)) throw_overflow(largest, what);
  }
  return deviation;
}

}  // namespace graze

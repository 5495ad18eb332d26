#pragma once

// This is private to engine/mesh.

#include <graze/bvh/aabb.h>
#include <graze/bvh/value/rigid.h>

#include <cmath>

namespace graze {

/// If sizes add up to less than this, nothing that is made of them can overflow.
inline constexpr double kFarFromOverflow = 0x1p1000;

/// Returns the sum of all that the corners of a box add to a placed coordinate.
inline double sum_of_sizes(const Aabb& bounds) {
  double sum = 0;
  for (int k = 0; k < 3; ++k)
    sum += std::abs(bounds.min.data()[k]) + std::abs(bounds.max.data()[k]);
  return sum;
}

/// True if check_placement() surely lets in a pose whose rotation is off by `error`, for bounds of
/// this sum_of_sizes(): so it does nearly all poses. Entries of a rotation enlarge nothing.
inline bool is_surely_placeable(const Pose& pose, const bvh::RotationError& error, double sizes) {
  const double* t = pose.data() + 12;
  return bvh::is_rigid(pose, error) &&
         sizes + std::abs(t[0]) + std::abs(t[1]) + std::abs(t[2]) < kFarFromOverflow;
}

}  // namespace graze

#pragma once

#include <cstddef>

#include <Eigen/Geometry>

namespace graze {

/// A rigid motion: columns 0 to 2 rotate, column 3 translates in metres. It is unaligned, so that
/// the layout of every public type is the same whatever SIMD flags its user compiles with.
/// Eigen::Isometry3d converts to it.
using Pose = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;

/// True if all entries are equal: Eigen's poses have no operator for that.
inline bool are_equal(const Pose& pose_a, const Pose& pose_b) {
  return pose_a.matrix() == pose_b.matrix();
}

/// Hashes poses for tables of them, with PoseEqual.
struct PoseHash {
  std::size_t operator()(const Pose& pose) const noexcept;
};
/// Compares poses entry by entry for tables of them, with PoseHash.
struct PoseEqual {
  /// True if all entries are equal.
  bool operator()(const Pose& pose_a, const Pose& pose_b) const noexcept {
    return are_equal(pose_a, pose_b);
  }
};

/// The largest deviation from a rotation that the door lets in (law 10).
inline constexpr double kMaxRotationDeviation = 1e-6;

/// Returns max |R^T R - I| over the nine entries, computed in double: 0 for an exact rotation.
double rotation_deviation(const Pose& pose);

/// Throws PoseError, which begins with `what`, unless the pose is finite, its last row is
/// (0, 0, 0, 1), its determinant is positive and it deviates from a rotation by at most
/// kMaxRotationDeviation. Returns the deviation.
double check_rigid(const Pose& pose, const char* what);

}  // namespace graze

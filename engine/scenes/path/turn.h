#pragma once

// Computes rotations that come out the same, bit for bit, on every machine: halving angles needs a
// square root, where sines and cosines of the C library may differ by an ulp. Private to
// engine/scenes.

#include <Eigen/Core>

namespace graze::scenes {

/// Holds a unit quaternion (w, x, y, z).
struct Quaternion {
  double w = 1;
  double x = 0;
  double y = 0;
  double z = 0;
};

/// Returns the turn by so much of a full turn about a unit axis, counter-clockwise as seen from its
/// tip. It is off by some ulp of 1. `turns` must be finite.
Quaternion turned_by(const Eigen::Vector3d& axis, double turns);

/// Returns the rotation a fraction of the way along the shorter arc, at constant speed: spherical
/// linear interpolation (Shoemake 1985). Of two arcs of equal length it takes the one along which b
/// is as it is given. `fraction` is in [0, 1].
Quaternion between(const Quaternion& a, Quaternion b, double fraction);

/// Returns the quaternion of a matrix that is a rotation to 1e-6: that of the rotation from which
/// it deviates.
Quaternion quaternion_of(const Eigen::Matrix3d& rotation);

/// Returns the matrix, a rotation to some ulp.
Eigen::Matrix3d matrix_of(const Quaternion& q);

/// Returns the product of two matrices, without fused operations and in a fixed order.
Eigen::Matrix3d product(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);

}  // namespace graze::scenes

#pragma once

#include <Eigen/Core>

namespace graze {

/// A closed solid ellipsoid whose axes are the coordinate axes, metres. A semi-axis of 0 makes it
/// flat.
struct Ellipsoid {
  Eigen::Vector3d centre;     ///< metres
  Eigen::Vector3d semi_axes;  ///< along x, y and z; metres, not negative

  bool operator==(const Ellipsoid&) const = default;
};

/// Throws InputError, which begins with `what`, unless the ellipsoid is finite and no semi-axis is
/// negative.
void check_ellipsoid(const Ellipsoid& ellipsoid, const char* what);

}  // namespace graze

#pragma once

#include <Eigen/Core>

namespace graze {

/// A closed ball, metres: the points at most `radius` from `centre`. A radius of 0 is a point.
struct Sphere {
  Eigen::Vector3d centre;  ///< metres
  double radius;           ///< metres, not negative

  bool operator==(const Sphere&) const = default;
};

/// Throws InputError, which begins with `what`, unless the sphere is finite and its radius is not
/// negative.
void check_sphere(const Sphere& sphere, const char* what);

}  // namespace graze

#pragma once

#include <limits>

#include <Eigen/Core>

namespace graze {

/// A half line, or its first part: the points origin + s direction, s >= 0, that are at most
/// `max_distance` from the origin.
struct Ray {
  Eigen::Vector3d origin;                                         ///< metres
  Eigen::Vector3d direction;                                      ///< the direction, of any length
                                                                  ///< but 0
  double max_distance = std::numeric_limits<double>::infinity();  ///< metres along the ray

  bool operator==(const Ray&) const = default;
};

/// Throws InputError, which begins with `what`, unless origin and direction are finite, the
/// direction is not 0, and the distance is neither negative nor NaN.
void check_ray(const Ray& ray, const char* what);

}  // namespace graze

#pragma once

#include <Eigen/Core>

namespace graze {

/// A closed axis-aligned box, metres, in whatever frame its user says. `min <= max` holds in each
/// coordinate; flat boxes and points are boxes.
struct Aabb {
  Eigen::Vector3d min;  ///< the least value of each coordinate
  Eigen::Vector3d max;  ///< the greatest value of each coordinate

  bool operator==(const Aabb&) const = default;
};

/// Throws InputError, which begins with `what`, unless the box is finite and `min <= max`.
void check_box(const Aabb& box, const char* what);

}  // namespace graze

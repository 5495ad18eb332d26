#pragma once

#include <Eigen/Core>

namespace graze {

/// The closed convex hull of three points, metres: a triangle, or the segment or point that it
/// degenerates to.
struct Triangle {
  Eigen::Vector3d a;  ///< the first corner
  Eigen::Vector3d b;  ///< the second corner
  Eigen::Vector3d c;  ///< the third corner

  bool operator==(const Triangle&) const = default;
};

}  // namespace graze

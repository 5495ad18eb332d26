#pragma once

// How far a point is from the surface of a placed shape, by definitions that share nothing with the
// solvers of contacts.

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>
#include <graze/narrowphase/triangle.h>

#include <vector>

namespace graze::tests {

/// The surface of a shape, in the shape's own frame. Of a hull all triangles of its corners that no
/// corner is in front of: they cover its facets.
class Surface {
 public:
  explicit Surface(const Shape& shape);

  /// Metres, not negative. Of an ellipsoid to first order beside it, to a ten-thousandth; far from
  /// it no less than it is. Takes the pose for a rotation.
  double distance(const Pose& pose, const Eigen::Vector3d& point) const;

 private:
  Shape shape_;
  std::vector<Triangle> triangles_;
};

}  // namespace graze::tests

#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include <Eigen/Core>

namespace graze {

namespace narrowphase {
struct Hull;
}

/// The convex hull of points in a body's frame, metres. Immutable; a copy is a handle to the same
/// data.
class ConvexHull {
 public:
  /// Finds the hull; which points are its corners is exact. Points inside it, or within its faces
  /// and edges, are left out. Throws InputError, naming the point, for a coordinate that is not
  /// finite or beyond kLargestLength; for points that have no volume: none, or all in one point,
  /// line or plane, exactly; and for a hull whose box has no side of kSmallestLength. However thin
  /// it is, what has a volume is taken. O(n f) for f faces.
  explicit ConvexHull(std::span<const Eigen::Vector3d> points);

  /// In the order of the points that they were, which rounding may move by an ulp of the hull.
  std::size_t vertex_count() const;
  Eigen::Vector3d vertex(std::size_t index) const;

  /// As contacts count them: corners within 2^-21 of the hull's reach, the greatest distance from
  /// the middle of its box, of one plane lie in one face.
  std::size_t face_count() const;

  /// What the narrow phase reads.
  const narrowphase::Hull& data() const { return *hull_; }

 private:
  std::shared_ptr<const narrowphase::Hull> hull_;
};

}  // namespace graze

#pragma once

#include <cstddef>
#include <cstdint>
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

  /// As contacts count them: corners within 2^-21 of the hull's bounding radius, the greatest
  /// distance from the middle of its box, of one plane lie in one face.
  std::size_t face_count() const;

  /// Its facets, exactly: triangles of corners are one only where they lie in one plane to the last
  /// bit.
  std::size_t facet_count() const;
  /// The vertices of a facet, counter-clockwise from outside. Valid as long as the hull or a copy
  /// is. Throws std::out_of_range for an index that is not below facet_count().
  std::span<const std::uint32_t> facet(std::size_t index) const;

  /// True if both are handles to the same hull.
  friend bool operator==(const ConvexHull& a, const ConvexHull& b) { return a.hull_ == b.hull_; }

 private:
  friend struct ConvexHullAccess;
  std::shared_ptr<const narrowphase::Hull> hull_;
};

}  // namespace graze

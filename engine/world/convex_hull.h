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

/// The convex hull of points in a body's frame, metres. It is immutable, and a copy is a handle to
/// the same data.
class ConvexHull {
 public:
  /// Finds the hull; which points are its corners is decided exactly. Points inside the hull, or
  /// within its faces and edges, are left out. Throws InputError, naming the point, for a
  /// coordinate that is not finite or beyond kLargestLength; InputError too for points without
  /// volume, which are none at all or lie, exactly, in one point, line or plane; and for a hull
  /// whose box has no side as long as kSmallestLength. A hull with a volume is taken however thin
  /// it is. It costs O(n f) for f faces.
  explicit ConvexHull(std::span<const Eigen::Vector3d> points);

  /// The vertices of the hull, in the order of the points that they come from. Rounding may move
  /// them by an ulp of the hull's size.
  std::size_t vertex_count() const;
  Eigen::Vector3d vertex(std::size_t index) const;

  /// Returns the number of faces as contacts count them: corners lie in one face if they are within
  /// 2^-21 of the hull's bounding radius, its greatest distance from the middle of its box, of one
  /// plane.
  std::size_t face_count() const;

  /// Returns the number of facets, exactly: triangles of corners form one facet only where they lie
  /// in one plane to the last bit.
  std::size_t facet_count() const;
  /// Returns the vertices of a facet, counter-clockwise as seen from outside. The span is valid as
  /// long as the hull or a copy of it exists. Throws std::out_of_range for an index that is not
  /// below facet_count().
  std::span<const std::uint32_t> facet(std::size_t index) const;

  /// True if both are handles to the same hull.
  friend bool operator==(const ConvexHull& a, const ConvexHull& b) { return a.hull_ == b.hull_; }

 private:
  friend struct ConvexHullAccess;
  std::shared_ptr<const narrowphase::Hull> hull_;
};

}  // namespace graze

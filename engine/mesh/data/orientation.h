#pragma once

// This tells whether the triangles of a mesh tell inside from outside. It is private to the
// library.

#include <graze/engine/mesh/mesh.h>

#include <cstdint>
#include <optional>

namespace graze {

/// An edge of a triangle: from corner k to the next.
struct TriangleEdge {
  std::uint32_t triangle;
  int k;
};

/// The first edges, in the order of triangles, at which triangles do not go on from each other.
struct Orientation {
  /// The first edge along which not as many triangles go as against it: the surface ends there, or
  /// turns round.
  std::optional<TriangleEdge> unpaired;
  /// The first edge along which at least two more triangles go one way than the other: their fronts
  /// are on different sides.
  std::optional<TriangleEdge> turned;
};

/// Returns the orientation. It is computed when it is first asked for, in O(n log n).
const Orientation& orientation_of(const Mesh& mesh);

}  // namespace graze

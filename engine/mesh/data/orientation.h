#pragma once

// Whether the triangles of a mesh tell inside from outside. Private to the library.

#include <graze/engine/mesh/mesh.h>

#include <cstdint>
#include <optional>

namespace graze {

/// An edge of a triangle: from corner k to the next.
struct TriangleEdge {
  std::uint32_t triangle;
  int k;
};

/// Where triangles at an edge do not go on from each other: the first in the order of triangles.
struct Orientation {
  /// Not as many triangles go along it as against it: the surface ends there, or turns round.
  std::optional<TriangleEdge> unpaired;
  /// At least two more go one way than the other: their fronts are on different sides.
  std::optional<TriangleEdge> turned;
};

/// Computed when it is first asked for. O(n log n).
const Orientation& orientation_of(const Mesh& mesh);

}  // namespace graze

#pragma once

#include <graze/engine/mesh/mesh.h>

#include <array>
#include <cstdint>
#include <set>
#include <vector>

namespace graze::tests {

/// A unit cube, by its lowest corner.
using Cell = std::array<int, 3>;

/// Squares by the numbers of their corners, counter-clockwise as seen from outside.
struct CubeSurface {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 4>> squares;

  /// Two triangles for each square.
  Mesh mesh() const;
};

/// The surface of a solid of cubes: the squares that have a cube on one side alone. At an edge
/// where two cubes stand corner to corner four of them meet.
CubeSurface surface_of_cubes(const std::set<Cell>& cells);

}  // namespace graze::tests

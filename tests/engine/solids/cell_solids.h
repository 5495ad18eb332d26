#pragma once

#include <graze/engine/mesh/mesh.h>

#include <set>

#include "tests/shapes/cubes.h"
#include "tests/shapes/random_source.h"

namespace graze::tests {

/// A solid of cubes of a lattice, whose interiors are known by their numbers.
struct CellSolid {
  int edge = 1;  ///< of a cube; cells (i, j, k) begin at edge (i, j, k)
  std::set<Cell> cells;

  /// The same solid in cubes of edge 1.
  std::set<Cell> unit_cells() const;
};

/// Whether the open interiors have a point in common.
bool have_common_cell(const CellSolid& a, const CellSolid& b);

/// Its surface: two triangles for each square that has a cell on one side alone. Diagonals, the
/// order of triangles and the sense in which each turns are drawn at random.
Mesh surface_of(const CellSolid& solid, RandomSource& source);

/// A box of cells, [low, high) along each axis.
CellSolid block(const Cell& low, const Cell& high);

}  // namespace graze::tests

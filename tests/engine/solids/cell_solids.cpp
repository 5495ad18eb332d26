#include "tests/engine/solids/cell_solids.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace graze::tests {
std::set<Cell> CellSolid::unit_cells() const {
  std::set<Cell> units;
  for (const Cell& cell : cells) {
    for (int n = 0; n < edge * edge * edge; ++n) {
      units.insert({edge * cell[0] + n % edge, edge * cell[1] + n / edge % edge,
                    edge * cell[2] + n / edge / edge});
    }
  }
  return units;
}

bool have_common_cell(const CellSolid& a, const CellSolid& b) {
  const std::set<Cell> units_a = a.unit_cells(), units_b = b.unit_cells();
  return std::any_of(units_a.begin(), units_a.end(),
                     [&](const Cell& cell) { return units_b.contains(cell); });
}

Mesh surface_of(const CellSolid& solid, RandomSource& source) {
  CubeSurface surface = surface_of_cubes(solid.cells);
  for (Eigen::Vector3d& vertex : surface.vertices)
    vertex *= solid.edge;
  for (auto& square : surface.squares) {
    if (source.integer(0, 1) == 0) std::rotate(square.begin(), square.begin() + 1, square.end());
  }
  const Mesh turned_alike = surface.mesh();
  std::vector<TriangleIndices> triangles(turned_alike.triangles().begin(),
                                         turned_alike.triangles().end());
  for (std::size_t i = triangles.size(); i > 1; --i) {
    TriangleIndices& triangle = triangles[i - 1];
    const auto other = static_cast<std::size_t>(source.integer(0, static_cast<int>(i) - 1));
    std::swap(triangle, triangles[other]);
    std::rotate(triangle.begin(), triangle.begin() + static_cast<int>(source.integer(0, 2)),
                triangle.end());
    if (source.integer(0, 1) == 0) std::swap(triangle[0], triangle[1]);
  }
  return {surface.vertices, triangles};
}

CellSolid block(const Cell& low, const Cell& high) {
  CellSolid solid;
  for (int i = low[0]; i < high[0]; ++i) {
    for (int j = low[1]; j < high[1]; ++j) {
      for (int k = low[2]; k < high[2]; ++k)
        solid.cells.insert({i, j, k});
    }
  }
  return solid;
}

}  // namespace graze::tests

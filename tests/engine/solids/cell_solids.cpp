#include "tests/engine/solids/cell_solids.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace graze::tests {
namespace {

/// Vertices by their numbers on the lattice.
class Vertices {
 public:
  explicit Vertices(int edge) : edge_(edge) {}

  std::uint32_t number(const Cell& at) {
    const auto [known, is_new] = numbers_.emplace(at, static_cast<std::uint32_t>(list_.size()));
    if (is_new) list_.emplace_back(edge_ * at[0], edge_ * at[1], edge_ * at[2]);
    return known->second;
  }
  const std::vector<Eigen::Vector3d>& list() const { return list_; }

 private:
  int edge_;
  std::map<Cell, std::uint32_t> numbers_;
  std::vector<Eigen::Vector3d> list_;
};

}  // namespace

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
  Vertices vertices(solid.edge);
  std::vector<TriangleIndices> triangles;
  for (const Cell& cell : solid.cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int step : {0, 1}) {
        Cell beyond = cell;
        beyond[axis] += step == 0 ? -1 : 1;
        if (solid.cells.contains(beyond)) continue;
        std::array<std::uint32_t, 4> square;
        for (std::size_t i = 0; i < 4; ++i) {
          Cell corner = cell;
          corner[axis] += step;
          corner[(axis + 1) % 3] += i == 1 || i == 2;
          corner[(axis + 2) % 3] += i >= 2;
          square[i] = vertices.number(corner);
        }
        if (source.integer(0, 1) == 0)
          std::rotate(square.begin(), square.begin() + 1, square.end());
        triangles.push_back({square[0], square[1], square[2]});
        triangles.push_back({square[0], square[2], square[3]});
      }
    }
  }
  for (std::size_t i = triangles.size(); i > 1; --i) {
    TriangleIndices& triangle = triangles[i - 1];
    const auto other = static_cast<std::size_t>(source.integer(0, static_cast<int>(i) - 1));
    std::swap(triangle, triangles[other]);
    std::rotate(triangle.begin(), triangle.begin() + static_cast<int>(source.integer(0, 2)),
                triangle.end());
    if (source.integer(0, 1) == 0) std::swap(triangle[0], triangle[1]);
  }
  return {vertices.list(), triangles};
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

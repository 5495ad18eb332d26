#include "tests/shapes/cubes.h"

#include <map>

namespace graze::tests {

Mesh CubeSurface::mesh() const {
  std::vector<TriangleIndices> triangles;
  triangles.reserve(2 * squares.size());
  for (const auto& square : squares) {
    triangles.push_back({square[0], square[1], square[2]});
    triangles.push_back({square[0], square[2], square[3]});
  }
  return {vertices, triangles};
}

CubeSurface surface_of_cubes(const std::set<Cell>& cells) {
  CubeSurface surface;
  std::map<Cell, std::uint32_t> numbers;
  const auto number = [&](const Cell& at) {
    const auto next = static_cast<std::uint32_t>(surface.vertices.size());
    const auto [known, is_new] = numbers.emplace(at, next);
    if (is_new) surface.vertices.emplace_back(at[0], at[1], at[2]);
    return known->second;
  };
  for (const Cell& cell : cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int step : {0, 1}) {
        Cell beyond = cell;
        beyond[axis] += step == 0 ? -1 : 1;
        if (cells.contains(beyond)) continue;
        auto& square = surface.squares.emplace_back();
        for (std::size_t i = 0; i < 4; ++i) {
          Cell corner = cell;
          corner[axis] += step;
          corner[(axis + 1) % 3] += i == 1 || i == 2;
          corner[(axis + 2) % 3] += i >= 2;
          square[step == 1 ? i : 3 - i] = number(corner);
        }
      }
    }
  }
  return surface;
}

}  // namespace graze::tests

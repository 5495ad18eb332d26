#pragma once

#include <graze/narrowphase/triangle.h>

#include <array>
#include <cstddef>

namespace graze::narrowphase {

/// Holds triangles coordinate by coordinate: rows x, y, z of corner a, of b, of c, all of one
/// length. A view: the caller keeps the memory.
struct TriangleRows {
  std::array<const double*, 9> row;
  std::size_t size;

  Triangle operator[](std::size_t index) const {
    return {{row[0][index], row[1][index], row[2][index]},
            {row[3][index], row[4][index], row[5][index]},
            {row[6][index], row[7][index], row[8][index]}};
  }
};

}  // namespace graze::narrowphase

#pragma once

#include <graze/bvh/aabb.h>

#include <array>
#include <cstddef>

namespace graze::narrowphase {

/// Holds boxes coordinate by coordinate: rows x, y, z of min, of max, all of one length. A view:
/// the caller keeps the memory.
struct AabbRows {
  std::array<const double*, 6> row;
  std::size_t size;

  Aabb operator[](std::size_t index) const {
    return {{row[0][index], row[1][index], row[2][index]},
            {row[3][index], row[4][index], row[5][index]}};
  }
};

}  // namespace graze::narrowphase

#pragma once

#include <graze/narrowphase/triangle.h>

namespace graze::narrowphase {

/// The nine coordinates of a triangle: x, y, z of a, of b, of c.
inline const double* coordinates(const Triangle& triangle) {
  static_assert(sizeof(Triangle) == 9 * sizeof(double));
  return reinterpret_cast<const double*>(&triangle);
}

}  // namespace graze::narrowphase

#pragma once

#include <graze/narrowphase/triangle.h>

namespace graze::narrowphase {

/// Returns the nine coordinates of a triangle: x, y, z of a, of b, of c.
inline const double* coordinates(const Triangle& triangle) {
  static_assert(sizeof(Triangle) == 9 * sizeof(double));
  return reinterpret_cast<const double*>(&triangle);
}

/// Holds the corners of a triangle in space, each an array of three numbers: doubles, or integers
/// that stand for them (fixed_point.h).
template <typename Number>
struct Corners {
  const Number* point[3];
};

inline Corners<double> corners_of(const Triangle& triangle) {
  return {{triangle.a.data(), triangle.b.data(), triangle.c.data()}};
}

}  // namespace graze::narrowphase

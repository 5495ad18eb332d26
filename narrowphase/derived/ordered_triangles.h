#pragma once

#include <graze/narrowphase/triangle.h>

namespace graze::narrowphase {

/// Two triangles in the one order in which derived values are computed (law 4): the corners of each
/// ascend lexicographically, and so do the triangles. Negative zeros have become positive.
struct OrderedTriangles {
  double a[3][3];
  double b[3][3];
  bool is_swapped;  ///< `a` holds what was given as B
};

OrderedTriangles ordered(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze::narrowphase

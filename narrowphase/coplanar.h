#pragma once

#include <graze/narrowphase/predicates.h>

namespace graze::narrowphase {

/// The corners of a triangle in space, each an array of three doubles.
struct Corners {
  const double* point[3];
};

/// True if and only if the projections of the two closed triangles along `axis` share a point,
/// exactly. Projections that degenerate to segments and points are what they are.
bool projections_intersect(const Corners& triangle_a, const Corners& triangle_b, int axis);

/// True if and only if the closed segments [a0, a1] and [b0, b1] in space share a point, exactly.
/// Segments that are points are what they are.
bool segments_intersect(const double* a0, const double* a1, const double* b0, const double* b1);

}  // namespace graze::narrowphase

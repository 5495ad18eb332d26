#pragma once

#include <graze/narrowphase/triangle.h>

namespace graze::oracle {

/// Whether the relative interiors of the two triangles meet and no plane holds both, in rationals.
/// The relative interior of the convex hull of points is the set of their combinations with
/// positive weights only. Whether some combination of both kinds is one point is asked of a linear
/// system, and whether a plane holds all six points of the rank of their differences; neither is an
/// orientation of the library's.
bool crosses_by_elimination(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze::oracle

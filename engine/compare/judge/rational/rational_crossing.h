#pragma once

#include <graze/engine/compare/judge/rational/rational_triangle.h>

namespace graze::compare {

/// Whether one plane holds all six corners.
bool are_coplanar(const RationalTriangle& triangle_a, const RationalTriangle& triangle_b);

/// Whether the relative interiors of the two share a point and no plane holds both: what
/// Touch::Exclude counts. Each triangle is cut with the other's plane; the two open segments that
/// result lie on one line, and overlap or do not (Moeller, "A fast triangle-triangle intersection
/// test", Journal of Graphics Tools 2(2), 1997), here in rational numbers.
bool do_cross(const RationalTriangle& triangle_a, const RationalTriangle& triangle_b);

}  // namespace graze::compare

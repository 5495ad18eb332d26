#pragma once

#include <graze/narrowphase/triangle.h>

namespace graze {

/// True if and only if the two closed triangles share a point, in real arithmetic (law 2). Touching
/// counts; degenerate triangles are what they are; every finite double is answered exactly.
/// Throws InputError for a coordinate that is not finite.
/// Guigue and Devillers, "Fast and robust triangle-triangle overlap test using orientation
/// predicates", Journal of Graphics Tools 8(1), 2003.
bool intersects(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze

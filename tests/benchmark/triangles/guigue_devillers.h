#pragma once

#include <graze/narrowphase/triangle.h>

namespace graze::benchmark {

/// Guigue and Devillers' test in plain double, as its users have it: determinants are rounded and
/// compared with zero. Fast, and wrong where rounding decides. Coplanar pairs by separating edges
/// in the projection along the largest component of the normal.
bool guigue_devillers(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze::benchmark

#pragma once

#include "tests/benchmark/error/baselines/plain.h"

namespace graze::benchmark {

/// Guigue and Devillers' test, rounded, as its users have it: determinants are compared with zero,
/// after `snap`. Coplanar pairs by separating edges in the projection along the largest component
/// of the normal. For float and double, with NoSnap and Snap.
template <typename Real, typename Snapping>
bool guigue_devillers(const Corners<Real>& triangle_a, const Corners<Real>& triangle_b,
                      Snapping snap);

}  // namespace graze::benchmark

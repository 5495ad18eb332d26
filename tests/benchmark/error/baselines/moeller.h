#pragma once

#include "tests/benchmark/error/baselines/plain.h"

namespace graze::benchmark {

/// Möller, "A fast triangle-triangle intersection test", Journal of Graphics Tools 2(2), 1997,
/// rounded: the intervals in which the triangles meet the line of their planes. The distances from
/// the planes are compared with zero after `snap`. For float and double, with NoSnap and Snap.
template <typename Real, typename Snapping>
bool moeller(const Corners<Real>& triangle_a, const Corners<Real>& triangle_b, Snapping snap);

}  // namespace graze::benchmark

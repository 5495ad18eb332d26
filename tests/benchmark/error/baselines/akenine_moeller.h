#pragma once

#include "tests/benchmark/error/baselines/plain.h"

namespace graze::benchmark {

/// Akenine-Möller's thirteen axes, rounded: the box is centred, and what sticks out beyond its
/// radius along an axis, after `snap`, is compared with zero. For float and double, with NoSnap and
/// Snap.
template <typename Real, typename Snapping>
bool akenine_moeller(const Corners<Real>& triangle, const Real* box_min, const Real* box_max,
                     Snapping snap);

}  // namespace graze::benchmark

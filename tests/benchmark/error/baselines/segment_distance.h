#pragma once

#include "tests/benchmark/error/baselines/plain.h"

namespace graze::benchmark {

/// The distance of two triangles, rounded: nine pairs of edges, six vertices over faces, the least
/// of fifteen, or 0 if an edge crosses a face. Ericson, "Real-Time Collision Detection", 2005,
/// 5.1.9, 5.1.5 and 5.3.6. For float and double.
template <typename Real>
Real segment_distance(const Corners<Real>& triangle_a, const Corners<Real>& triangle_b);

}  // namespace graze::benchmark

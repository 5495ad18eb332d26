#pragma once

#include "tests/benchmark/error/baselines/plain.h"

// Do a point and a triangle, or two edges, of four points on straight paths meet on the way? As it
// is usually asked, in rounded numbers.

namespace graze::benchmark {

/// Where four points are at both ends: a point and the corners of a triangle, or the ends of one
/// edge and of another.
template <typename Real>
struct PlainPaths {
  Real start[4][3];
  Real end[4][3];
};

/// The roots of the cubic that is zero where all four are in one plane, and whether the point is in
/// the triangle then. Roots and weights may be outside of [0, 1] by `epsilon`. Provot, "Collision
/// and self-collision handling in cloth model dedicated to design garments", 1997; Bridson,
/// Fedkiw, Anderson, "Robust treatment of collisions, contact and friction for cloth animation",
/// 2002. For float and double.
template <typename Real>
bool cubic_point(const PlainPaths<Real>& paths, Real epsilon);

/// Likewise of two edges.
template <typename Real>
bool cubic_edges(const PlainPaths<Real>& paths, Real epsilon);

/// The box of time and weights is halved until the difference of both places is within 1e-6 of zero
/// all over a part, or until 100,000 parts were looked at, which counts as a meeting. Never misses,
/// and meets too much. Wang, Ferguson, Schneider, Jiang, Attene, Panozzo, "A large-scale benchmark
/// and an inclusion-based algorithm for continuous collision detection", 2021; Snyder, "Interval
/// analysis for computer graphics", 1992.
bool inclusion_point(const PlainPaths<double>& paths);
bool inclusion_edges(const PlainPaths<double>& paths);

}  // namespace graze::benchmark

#pragma once

#include <graze/narrowphase/convex/core/core.h>

namespace graze::narrowphase {

enum class GapVerdict {
  Apart,       ///< proved: the direction -normal separates, `lower` says by how much
  Touching,    ///< the cores share a point, or come as near as rounding tells apart
  NotReached,  ///< the iterations ended in between: the bounds hold, the verdict is open
};

/// Holds what is known of the gap between two cores, metres: lower <= gap <= upper, but for the
/// rounding that `slack` bounds and that is taken off `lower`.
struct CoreGap {
  GapVerdict verdict;
  double lower;
  double upper;
  double slack;
  Vec3 point_a;  ///< a point of core A
  Vec3 point_b;  ///< a point of core B, `upper` from `point_a`
  Vec3 normal;   ///< unit, from A to B; where cores touch, the last direction of the search
};

/// Says when to stop before the gap is known as well as doubles can.
struct GapGoal {
  double apart_beyond = -1;  ///< stop as soon as `lower` exceeds this; negative: never
  double near_enough = -1;   ///< stop as soon as `upper` is at most this; negative: never
};

/// Finds the distance of two cores with its witnesses, by GJK. Every bound is a proof: `upper` is
/// the distance of two points of the cores, `lower` that of two planes between them, which any
/// direction gives whatever its own error. Polytopes end after a few steps; curved cores close in
/// on the answer, until the bounds are within 2^-34 of the scale or kLargestSteps are done.
/// Gilbert, Johnson, Keerthi, "A fast procedure for computing the distance between complex objects
/// in three-dimensional space" (1988); van den Bergen, "A fast and robust GJK implementation"
/// (1999).
CoreGap core_gap(const Core& a, const Core& b, const GapGoal& goal = {});

inline constexpr int kLargestSteps = 128;

}  // namespace graze::narrowphase

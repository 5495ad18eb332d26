#pragma once

#include <graze/bvh/lanes.h>

namespace graze::bvh {

/// Half surfaces below this underflow when they are split further.
constexpr float kSmallestSurface = 1e-30f;

/// Primitives on one line have no surface that could tell splits apart: their length does.
enum class Measure { Surface, Length };

static inline float measured(const Bounds& box, Measure measure) {
  const Lanes d = size_of(box);
  return measure == Measure::Surface ? d[0] * (d[1] + d[2]) + d[1] * d[2] : d[0] + d[1] + d[2];
}

static inline Measure measure_for(const Bounds& box) {
  return measured(box, Measure::Surface) > kSmallestSurface ? Measure::Surface : Measure::Length;
}

/// The measures of four boxes whose sizes along x, y and z are given lane by lane.
static inline Lanes measured(Lanes x, Lanes y, Lanes z, Measure measure) {
  return measure == Measure::Surface ? x * (y + z) + y * z : x + y + z;
}

/// At most this many rows are swept at once.
constexpr int kMostRows = 16;

/// What lies at one place along each of the three axes, such as a bin of centroids. A power of two
/// in size, so that finding one by its number is a shift.
struct alignas(128) SweepRow {
  Bounds box[3];
  IntLanes count;  // of primitives, an axis each; without any, the box is empty_bounds()
};

static inline SweepRow empty_row() {
  return {{empty_bounds(), empty_bounds(), empty_bounds()}, IntLanes{}};
}

/// A cut before a row. `cost` is the sum over both sides of primitives times the measure of their
/// box. axis is negative when none has primitives on both sides.
struct Cut {
  int axis = -1;
  int row = 0;
  float cost = 0;
};

/// The cheapest cut along all axes; of equals the one of the lowest axis and row.
Cut cheapest_cut(const SweepRow* rows, int count, Measure measure);

}  // namespace graze::bvh

#pragma once

#include <graze/bvh/value/lanes.h>

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
  IntLanes count;  ///< of primitives, an axis each; without any, the box is empty_bounds()
};

static inline SweepRow empty_row() {
  return {{empty_bounds(), empty_bounds(), empty_bounds()}, IntLanes{}};
}

/// What primitives are weighed by: the measure of their box, times how many they are and, for each
/// place that they leave empty in leaves of so many, a share of one more.
struct SweepCosts {
  Measure measure = Measure::Surface;
  float leaf_size = 1;    ///< at least 1
  float empty_place = 0;  ///< of a primitive
};

/// So many primitives, with the places that they leave empty; 0 for none, whatever rounds. Where
/// only some primitives are looked at, the places are theirs.
static inline Lanes weight_of(Lanes count, const SweepCosts& costs) {
  const Lanes size = all_lanes(costs.leaf_size);
  const IntLanes full_leaves = __builtin_convertvector(count / size, IntLanes);
  const Lanes in_full = __builtin_convertvector(full_leaves, Lanes) * size;
  const Lanes places = in_full + chosen(in_full < count, size, all_lanes(0));
  return count + (places - count) * costs.empty_place;
}

/// A cut before a row. `cost` is the sum over both sides of their primitives' weight times the
/// measure of their box. axis is negative when none has primitives on both sides.
struct Cut {
  int axis = -1;
  int row = 0;
  float cost = 0;
};

/// The cheapest cut along all axes; of equals the one of the lowest axis and row.
Cut cheapest_cut(const SweepRow* rows, int count, const SweepCosts& costs);

}  // namespace graze::bvh

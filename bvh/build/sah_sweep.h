#pragma once

#include <graze/bvh/value/lanes.h>

namespace graze::bvh {

/// Half surfaces below this underflow when they are split further.
constexpr float kSmallestSurface = 1e-30f;

/// The measures by which splits are compared. Primitives on one line have no surface that could
/// tell splits apart: their length does.
enum class Measure { Surface, Length };

static inline float measured(const Bounds& box, Measure measure) {
  const Lanes d = size_of(box);
  return measure == Measure::Surface ? d[0] * (d[1] + d[2]) + d[1] * d[2] : d[0] + d[1] + d[2];
}

static inline Measure measure_for(const Bounds& box) {
  return measured(box, Measure::Surface) > kSmallestSurface ? Measure::Surface : Measure::Length;
}

/// Returns the measures of four boxes whose sizes along x, y and z are given lane by lane.
static inline Lanes measured(Lanes x, Lanes y, Lanes z, Measure measure) {
  return measure == Measure::Surface ? x * (y + z) + y * z : x + y + z;
}

/// The largest number of rows that are swept at once.
constexpr int kMostRows = 16;

/// The primitives at one place along each of the three axes, such as a bin of centroids. Its size
/// is a power of two, so that finding one by its number is a shift.
struct alignas(128) SweepRow {
  Bounds box[3];
  IntLanes count;  ///< the number of primitives for each axis; without any, the box is
                   ///< empty_bounds()
};

static inline SweepRow empty_row() {
  return {{empty_bounds(), empty_bounds(), empty_bounds()}, IntLanes{}};
}

/// The costs by which primitives are weighed: the measure of their box, times how many they are
/// and, for each place that they leave empty in leaves of `leaf_size`, a share of one more.
struct SweepCosts {
  Measure measure = Measure::Surface;
  float leaf_size = 1;    ///< how many places a leaf has, at least 1
  float empty_place = 0;  ///< the cost of an empty place as a share of a primitive's
};

/// Returns the weight of so many primitives, with the places that they leave empty; 0 for none,
/// whatever rounds. Where only some primitives are looked at, the places are theirs.
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

/// Returns the cheapest cut along all axes; of equals the one of the lowest axis and row.
Cut cheapest_cut(const SweepRow* rows, int count, const SweepCosts& costs);

}  // namespace graze::bvh

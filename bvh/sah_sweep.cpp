#include <graze/bvh/sah_sweep.h>

namespace graze::bvh {
namespace {

void merge_into(Bounds (&sum)[3], const SweepRow& row) {
  for (int k = 0; k < 3; ++k)
    sum[k] = merged(sum[k], row.box[k]);
}

/// Of three boxes, one per lane.
Lanes measured(const Bounds (&box)[3], Measure measure) {
  const Lanes a = size_of(box[0]);
  const Lanes b = size_of(box[1]);
  const Lanes c = size_of(box[2]);
  const Lanes low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Lanes high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  return measured(__builtin_shufflevector(low, c, 0, 1, 4, 4),
                  __builtin_shufflevector(low, c, 2, 3, 5, 5),
                  __builtin_shufflevector(high, c, 0, 1, 6, 6), measure);
}

}  // namespace

// A side without primitives costs zero times infinity: NaN, which is never below the best.
Cut cheapest_cut(const SweepRow* rows, int count, Measure measure) {
  Lanes cost_behind[kMostRows];
  Bounds sum[3] = {empty_bounds(), empty_bounds(), empty_bounds()};
  Lanes number = all_lanes(0);
  for (int i = count - 1; i > 0; --i) {
    merge_into(sum, rows[i]);
    number += rows[i].count;
    cost_behind[i] = measured(sum, measure) * number;
  }
  sum[0] = sum[1] = sum[2] = empty_bounds();
  number = all_lanes(0);
  Lanes best = all_lanes(std::numeric_limits<float>::infinity());
  IntLanes best_row = {};
  for (int i = 1; i < count; ++i) {
    merge_into(sum, rows[i - 1]);
    number += rows[i - 1].count;
    const Lanes cost = measured(sum, measure) * number + cost_behind[i];
    const IntLanes is_better = cost < best;
    best = chosen(is_better, cost, best);
    best_row = chosen(is_better, IntLanes{i, i, i, i}, best_row);
  }
  Cut cut;
  for (int k = 0; k < 3; ++k) {
    if (best_row[k] > 0 && (cut.axis < 0 || best[k] < cut.cost)) cut = {k, best_row[k], best[k]};
  }
  return cut;
}

}  // namespace graze::bvh

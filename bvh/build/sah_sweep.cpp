#include <graze/bvh/build/sah_sweep.h>

namespace graze::bvh {
namespace {

/// The boxes and the primitives of the rows on one side of a cut.
struct Side {
  Bounds box[3] = {empty_bounds(), empty_bounds(), empty_bounds()};
  IntLanes count = {};

  void add(const SweepRow& row) {
    for (int k = 0; k < 3; ++k)
      box[k] = merged(box[k], row.box[k]);
    count += row.count;
  }

  /// Returns the primitives' weight times the measure of their box.
  Lanes cost(const SweepCosts& costs) const {
    const Lanes a = size_of(box[0]);
    const Lanes b = size_of(box[1]);
    const Lanes c = size_of(box[2]);
    const Lanes low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    const Lanes high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    return measured(__builtin_shufflevector(low, c, 0, 1, 4, 4),
                    __builtin_shufflevector(low, c, 2, 3, 5, 5),
                    __builtin_shufflevector(high, c, 0, 1, 6, 6), costs.measure) *
           weight_of(__builtin_convertvector(count, Lanes), costs);
  }
};

}  // namespace

// A side without primitives costs zero times infinity: NaN, which is never below the best.
Cut cheapest_cut(const SweepRow* rows, int count, const SweepCosts& costs) {
  Lanes cost_behind[kMostRows];
  Side behind;
  for (int i = count - 1; i > 0; --i) {
    behind.add(rows[i]);
    cost_behind[i] = behind.cost(costs);
  }
  Side front;
  Lanes best = all_lanes(std::numeric_limits<float>::infinity());
  IntLanes best_row = {};
  for (int i = 1; i < count; ++i) {
    front.add(rows[i - 1]);
    const Lanes cost = front.cost(costs) + cost_behind[i];
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

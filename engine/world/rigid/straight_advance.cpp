#include <graze/engine/world/rigid/straight_advance.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/pair_input.h>

#include <cmath>

namespace graze {
namespace {

using narrowphase::Core;

// Newton's method on a convex function needs a dozen steps, and some thirty where the two hardly
// touch in passing.
constexpr int kMostSteps = 1000;

// Shares of the scale: planes at right angles to the normal of a gap are no nearer to each other
// than its lower bound, but for 2^-46 (shape_pairs.h); the place of the moving set at t, the sum of
// an offset and a product, is off by less than 2^-50, and so are unit vectors.
constexpr double kGapRounding = 0x1p-45;
constexpr double kRateRounding = 0x1p-48;

// A quotient of numbers that are rounded down and up, and a sum of times, are each off by less than
// 2^-52.
constexpr double kTimeRounding = 1 - 0x1p-50;

}  // namespace

double StraightPair::scale() const {
  return pair_scale(still, moving) + length(displacement);
}

std::optional<StraightMeeting> first_meeting(const StraightPair& pair, const TimeStretch& stretch,
                                             Work& work) {
  const double scale = pair.scale(), travel = length(pair.displacement);
  Core moved = pair.moving;
  StraightMeeting last{stretch.from, {}, {0, 0, 1}};
  for (int step = 0;; ++step) {
    moved.at = pair.moving.at + pair.displacement * last.time;
    const SetGap gap = gap_of_sets(pair.still, moved);
    ++work.convex_tests;
    if (gap.is_apart || step == 0) last.normal = gap.normal;
    last.point = gap.point_a;
    const double left = gap.lower - kGapRounding * scale;
    // The gap closes by no more than this in all of time.
    const double rate = kRateRounding * travel - dot(last.normal, pair.displacement);
    if (left > 0 && !(left * kTimeRounding < rate * (stretch.until - last.time)))
      return std::nullopt;
    const bool is_open = step == kMostSteps;
    if (is_open || gap.lower <= kTouchTolerance * scale) {
      work.convex_failures += is_open || gap.status == PairStatus::NotConverged;
      return last;
    }
    last.time = (last.time + left / rate * kTimeRounding) * kTimeRounding;
  }
}

}  // namespace graze

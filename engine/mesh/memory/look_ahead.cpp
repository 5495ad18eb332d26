#include <graze/engine/mesh/memory/look_ahead.h>

#include <algorithm>

namespace graze {
namespace {

/// A longer look-ahead must cost less by this factor to be kept.
constexpr double kWorth = 1.1;

}  // namespace

void LookAhead::learn(double cost) {
  double& known = cost_[level_];
  known = known > 0 ? 0.5 * (known + cost) : cost;
  const bool was_new = is_new_;
  is_new_ = false;
  if (level_ > 0 && kWorth * known > cost_[level_ - 1]) {
    known = 0;
    --level_;
    hold_ = next_hold_;
    next_hold_ = std::min(2 * next_hold_, kLongestHold);
  } else if (hold_ > 0) {
    --hold_;
  } else if (level_ + 1 < kLevels) {
    if (was_new) next_hold_ = kFirstHold;
    ++level_;
    is_new_ = true;
  }
}

}  // namespace graze

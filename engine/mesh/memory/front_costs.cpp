#include <graze/engine/mesh/memory/front_costs.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

constexpr double kNotWorth = 1.1;  // times the cost of a walk
constexpr double kFarTooMuch = 2;
constexpr double kWellWorth = 0.7;

/// The first queries with a front tell little: a motion that has just come near costs more than
/// later.
constexpr int kEnoughQueries = 4;

/// How much the last query counts in the mean.
constexpr double kNewest = 0.25;

/// A longer look-ahead must cost less by this factor to be kept.
constexpr double kWorth = 1.1;

}  // namespace

// Fitted to what 644 poses and 361 motions of eight pairs of meshes took: half of them are within a
// tenth. Of boxes that a pass looks at half is counted, because what it opens serves later ones.
double FrontWorth::cost_of_walk(const Work& done) {
  return 106 + 4.8 * static_cast<double>(done.volume_tests) +
         7 * static_cast<double>(done.filter_tests) + 30 * static_cast<double>(done.triangle_tests);
}

double FrontWorth::cost_of_pass(const bvh::WideFront::Counts& done, std::size_t unsure) {
  return 290 + 8 * static_cast<double>(done.walk.box_tests) +
         9 * static_cast<double>(done.walk.primitive_tests) + 37 * static_cast<double>(unsure) +
         0.46 * static_cast<double>(done.skipped);
}

void FrontWorth::learn(double cost) {
  mean_ += (queries_ == 0 ? 1 : kNewest) * (cost - mean_);
  ++queries_;
}

bool FrontWorth::is_worth_it() const {
  const double most = queries_ >= kEnoughQueries ? kNotWorth : kFarTooMuch;
  return queries_ == 0 || !(mean_ > most * walk_);
}

bool FrontWorth::is_surely_worth_it() const {
  return queries_ >= kEnoughQueries && std::isfinite(walk_) && mean_ < kWellWorth * walk_;
}

void LookAhead::learn(double cost) {
  double& known = cost_[level_];
  known = known > 0 ? 0.5 * (known + cost) : cost;
  const bool was_new = is_new_;
  is_new_ = false;
  if (level_ > 0 && kWorth * known > cost_[level_ - 1]) {
    known = 0;
    --level_;
    wait_ = next_wait_;
    next_wait_ = std::min(2 * next_wait_, kLongestWait);
  } else if (wait_ > 0) {
    --wait_;
  } else if (level_ + 1 < kLevels) {
    if (was_new) next_wait_ = kFirstWait;
    ++level_;
    is_new_ = true;
  }
}

}  // namespace graze

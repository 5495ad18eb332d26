#include <graze/engine/mesh/memory/motion_front.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

/// These shares of a front were measured. Where after a jump nearly all budgets are spent, planes
/// prove no more; to look at a third of a front of distances costs as much as a walk of its own.
constexpr double kMostSpent = 0.7;
constexpr double kMostLookedAt = 0.35;
constexpr std::size_t kMostNearPairs = 250;  // distances that are asked for in one pass
constexpr int kLongestRest = 64;             // queries for which a front rests

/// The share of the edges of the smaller mesh's box, added up, that is fast: if B goes so far in
/// one query, it has to have done so before, or no front is begun for it.
constexpr double kFast = 0.005;

/// The number of updates after which a front has paid: to begin it costs as much as three walks.
constexpr int kEnoughPasses = 4;

/// The smallest front that is worth a prediction: in a smaller one the pairs that are due take less
/// time than a prediction. It was measured.
constexpr std::size_t kWorthAPrediction = 200;

/// A predicted motion is worth it while the motion spent is at most so many times the distance that
/// B has come. After one that was worth it for so many passes another is tried at once.
constexpr double kMostSpentPerDistance = 1.5;
constexpr int kEnoughPredicted = 8;

/// A front is given up that has grown so much: it grows with what opens and never closes.
constexpr int kMostPasses = 1000;
constexpr double kMostGrowth = 2;
constexpr double kMostGrowthOfDistances = 1.5;
constexpr std::size_t kFewMore = 64;

/// A front adds at most these shares of itself for later queries in one pass. They were measured.
constexpr double kMostAhead = 0.25;
constexpr std::size_t kFewAhead = 16;
constexpr double kLongestGap = 1000;  // queries

/// A motion that is longer than the one before by this factor is a jump.
constexpr double kJump = 4;

/// The largest size of a front: boxes beside eight others, leaves and triangles, of some 250 bytes
/// each.
constexpr std::size_t kLargest = std::size_t{1} << 19;

/// The costs of queries with a front, as shares of the cost of a walk, by which it is judged.
constexpr double kNotWorth = 1.1;  // times the cost of a walk
constexpr double kFarTooMuch = 2;
constexpr double kWellWorth = 0.7;

/// The number of queries with a front after which its cost is judged. The first tell little: a
/// motion that has just come near costs more than later.
constexpr int kEnoughQueries = 4;

/// The weight of the last query in the mean.
constexpr double kNewest = 0.25;

/// A longer look-ahead must cost less by this factor to be kept.
constexpr double kWorth = 1.1;

/// Returns the lengths of the edges in the three directions, added up.
double sum_of_edges(const bvh::FloatBox& box, double unit) {
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    sum += (double{box.max[i]} - double{box.min[i]}) * unit;
  return sum;
}

}  // namespace

// The costs are fitted to what 644 poses and 361 motions of eight pairs of meshes took: half of
// them are within a tenth. The factor of box tests of a pass counts half of them, because
// what it opens serves later ones.
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

void MotionFront::add_motion(const bvh::WideFront::MotionBound& step, int queries) {
  is_jump_ = step.distance > kJump * step_ * queries;
  step_ = step.distance / queries;
  queries_ = queries;
  // The factors round the sums up.
  motion_.distance = (motion_.distance + step.distance) * (1 + 0x1p-50);
  motion_.rotation_change = (motion_.rotation_change + step.rotation_change) * (1 + 0x1p-50);
  since_last_.distance = (since_last_.distance + step.distance) * (1 + 0x1p-50);
  since_last_.rotation_change =
      (since_last_.rotation_change + step.rotation_change) * (1 + 0x1p-50);
  if (!(motion_.distance < bvh::WideFront::kFarthest)) is_in_use_ = false;
}

void MotionFront::give_up() {
  is_in_use_ = false;
  rest_ = next_rest_;
  next_rest_ = std::min(4 * next_rest_, kLongestRest);
}

bool MotionFront::use_up_rest() {
  if (is_in_use_ || rest_ == 0) return false;
  --rest_;
  return true;
}

bool MotionFront::has_many_near_pairs(const bvh::WideFront::Pass& pass, double limit) {
  if (kind_ == bvh::WideFront::Kind::Intersection) return false;
  std::size_t due = 0;
  for (std::size_t i = 0; i < front_.near_pair_count(); ++i)
    due += front_.renew_budget(i, pass, limit) ? 0 : 1;
  return due > kMostNearPairs;
}

bool MotionFront::is_outgrown() const {
  const double most =
      kind_ == bvh::WideFront::Kind::Distance ? kMostGrowthOfDistances : kMostGrowth;
  return passes_ >= kMostPasses ||
         static_cast<double>(front_.size()) > most * static_cast<double>(first_size_) + kFewMore;
}

void MotionFront::update_prediction(const bvh::RelativeFrame (&now)[2]) {
  if (front_.has_prediction()) {
    ++passes_predicted_;
    distance_predicted_ += since_last_.distance;
    if (front_.spent() - spent_at_prediction_ > kMostSpentPerDistance * distance_predicted_) {
      front_.drop_prediction();
      next_unpredicted_ =
          passes_predicted_ >= kEnoughPredicted ? 1 : std::min(2 * next_unpredicted_, kLongestRest);
      passes_unpredicted_ = next_unpredicted_ - 1;
    }
  }
  if (!front_.has_prediction() && is_last_known_ && front_.size() >= kWorthAPrediction &&
      front_.crossing_count() + front_.unsure_count() > 0 && since_last_.distance > 0 &&
      passes_unpredicted_-- <= 0) {
    front_.set_prediction(last_, since_last_);
    passes_predicted_ = 0;
    distance_predicted_ = 0;
    spent_at_prediction_ = front_.spent();
  }
  std::copy_n(now, 2, last_);
  since_last_ = {};
  is_last_known_ = true;
}

std::optional<bvh::WideFront::Pass> MotionFront::start_pass(const bvh::WideTree& tree_a,
                                                            const bvh::WideTree& tree_b,
                                                            const bvh::RelativeFrame& b_in_a,
                                                            const bvh::RelativeFrame& a_in_b,
                                                            double limit) {
  if (!(limit < bvh::WideFront::kFarthest)) return std::nullopt;
  if (is_in_use_ && !is_outgrown()) {
    front_.move_to(b_in_a, a_in_b, motion_);
    if (!(front_.spent() < bvh::WideFront::kFarthest)) {
      is_in_use_ = false;
      return std::nullopt;
    }
    update_prediction({b_in_a, a_in_b});
    const bvh::WideFront::Pass pass = front_.start_pass(kind_);
    const bool is_worth_it = !is_jump_ || front_.share_spent(pass, limit) <= kMostSpent;
    if (is_worth_it && !has_many_near_pairs(pass, limit)) {
      const bool is_kept = kind_ == bvh::WideFront::Kind::Distance || worth_.is_surely_worth_it();
      if (passes_ >= kEnoughPasses && is_kept) next_rest_ = 1;
      return pass;
    }
    give_up();
    return std::nullopt;
  }
  const double smaller = std::min(sum_of_edges(tree_a.box(), b_in_a.units_a),
                                  sum_of_edges(tree_b.box(), b_in_a.units_b));
  is_in_use_ = false;
  if (is_jump_ && step_ > kFast * smaller) return std::nullopt;
  front_.begin(tree_a, tree_b, b_in_a, a_in_b);
  is_in_use_ = true;
  motion_ = {};
  passes_ = 0;
  worth_.begin();
  update_prediction({b_in_a, a_in_b});
  return front_.start_pass(kind_);
}

bvh::WideFront::Foresight MotionFront::foresight() const {
  const double look_ahead = look_ahead_.queries() * step_;
  // A motion far away and the one back are of one length, and neither counts as a jump beside the
  // other.
  const bool is_near = look_ahead < bvh::WideFront::kFarthest;
  if (kind_ == bvh::WideFront::Kind::Distance || is_jump_ || !is_near) return {};
  const std::size_t size = passes_ > 0 ? front_.size() : first_size_;
  return {
      .look_ahead = look_ahead,
      .useful = step_,
      .most_added = kFewAhead + static_cast<std::size_t>(kMostAhead * static_cast<double>(size))};
}

void MotionFront::learn(const bvh::WideFront::Pass& pass, double cost) {
  if (!(step_ > 0)) return;
  const double queries_left =
      std::clamp(std::floor(front_.proven_gap(pass) / step_), 0.0, kLongestGap);
  const double of_each = cost / (1 + queries_left);
  const double tried = look_ahead_.queries();
  look_ahead_.learn(of_each);
  // Pairs that were opened without need stay in the front: if it has grown much, it is given up.
  const bool was_in_vain = look_ahead_.queries() < tried;
  if (was_in_vain &&
      static_cast<double>(front_.size()) > kMostGrowth * static_cast<double>(first_size_))
    is_in_use_ = false;
  worth_.learn(of_each);
  if (is_in_use_ && !worth_.is_worth_it()) give_up();
}

void MotionFront::update(const bvh::WideFront::Pass& pass, double limit, Work& work) {
  is_in_use_ = false;  // the front is not used again if this throws
  const std::size_t size_before = front_.size();
  front_.update(pass, limit, foresight());
  is_in_use_ = true;
  const bvh::WideFront::Counts counts = front_.take_counts();
  if (passes_++ == 0) {
    first_size_ = front_.size();
    if (front_.share_spent(pass, limit + step_) > kMostSpent) give_up();
  } else if (kind_ == bvh::WideFront::Kind::Intersection) {
    learn(pass, FrontWorth::cost_of_pass(counts, front_.unsure_count()));
  } else if (static_cast<double>(front_.looked_at()) >
             kMostLookedAt * queries_ * static_cast<double>(size_before)) {
    give_up();
  }
  if (front_.size() > kLargest) {
    is_in_use_ = false;
    rest_ = kLongestRest;
  }
  work.volume_tests += counts.walk.box_tests;
  work.volume_rejections += counts.walk.box_rejections;
  work.treelets_built += counts.walk.treelets.built;
  work.treelets_refitted += counts.walk.treelets.refitted;
  work.filter_tests += counts.walk.primitive_tests;
  work.skipped_by_memory += counts.skipped;
}

}  // namespace graze

#include <graze/bvh/wide/front/wide_front.h>

#include <algorithm>
#include <limits>

namespace graze::bvh {
namespace {

/// The least distance of a predicted motion from one pass to the next, because the prediction is
/// divided by it.
constexpr double kLeastDistance = 0x1p-50;

/// The number of elements that vectors have room for at first.
constexpr std::size_t kFirstSize = 64;

/// Returns the largest budget that counts as spent within this limit. A gap leaves no more motion
/// than itself over the deviation, so that no pair within the limit has a later budget.
float spent_at(const WideFront::Pass& pass, double limit) {
  return rounded_up(pass.spent + (limit + 2 * pass.slack) / static_cast<double>(pass.deviation));
}

FrontHorizon horizon_at(const WideFront::Pass& pass, double limit) {
  return {limit > 0 ? rounded_up(limit) : 0, spent_at(pass, limit)};
}

std::size_t count_spent(const std::vector<float>& budgets, float spent) {
  return static_cast<std::size_t>(std::count_if(budgets.begin(), budgets.end(),
                                                [spent](float budget) { return budget <= spent; }));
}

}  // namespace

WideFront::Pass::Pass(const RelativeFrame& b_in_a, const RelativeFrame& a_in_b, Kind what)
    : kind(what),
      slack(std::max(b_in_a.slack, a_in_b.slack)),
      into{TreeTransform(b_in_a), TreeTransform(a_in_b)},
      units{static_cast<float>(b_in_a.units_a), static_cast<float>(a_in_b.units_a)} {}

void WideFront::Pass::aim_along(const double (&along)[3]) {
  const TreeTransform& of_a_in_b = into[1];
  for (int i = 0; i < 3; ++i) {
    direction[0][i] = static_cast<float>(along[i]);
    direction[1][i] = static_cast<float>(-(of_a_in_b.rotation[i][0] * along[0] +
                                           of_a_in_b.rotation[i][1] * along[1] +
                                           of_a_in_b.rotation[i][2] * along[2]));
  }
}

void WideFront::move_to(const RelativeFrame& b_in_a, const RelativeFrame& a_in_b,
                        const MotionBound& motion) {
  const RelativeFrame now[2] = {b_in_a, a_in_b};
  const double distance = motion.distance - motion_.distance;
  const double deviation = has_prediction_ ? prediction_.deviation(last_, now, distance) : 0;
  // If the deviation is NaN, so is the motion spent.
  spent_ =
      (spent_ + std::max(deviation / static_cast<double>(kDeviation), distance)) * (1 + 0x1p-50);
  motion_ = motion;
  std::copy_n(now, 2, last_);
}

WideFront::Pass WideFront::start_pass(Kind kind) const {
  Pass pass(last_[0], last_[1], kind);
  pass.spent = spent_;
  if (has_prediction_) {
    pass.deviation = kDeviation;
    pass.per_distance = prediction_.per_distance();
    for (int side = 0; side < 2; ++side)
      pass.predicted[side] = prediction_.displacement(side);
  }
  pass.since[0] = QueryDisplacement(first_[0], last_[0], *state_.tree[1], motion_.rotation_change);
  pass.since[1] = QueryDisplacement(first_[1], last_[1], *state_.tree[0], motion_.rotation_change);
  return pass;
}

void WideFront::begin(const WideTree& tree_a, const WideTree& tree_b, const RelativeFrame& b_in_a,
                      const RelativeFrame& a_in_b) {
  first_[0] = last_[0] = b_in_a;
  first_[1] = last_[1] = a_in_b;
  motion_ = {};
  spent_ = 0;
  has_prediction_ = false;
  state_.tree[0] = &tree_a;
  state_.tree[1] = &tree_b;
  state_.visits.reserve(kFirstSize);
  state_.leaves.reserve(kFirstSize);
  state_.visits.clear();
  state_.intersection.clear();
  state_.distance.clear();
  state_.visit_budgets.clear();
  state_.leaves.clear();
  state_.leaves_budgets.clear();
  state_.busy.clear();
  state_.near_pairs.clear();
  state_.near_pair_budgets.clear();
  state_.near_pair_planes.clear();
  state_.lanes = 0;
}

void WideFront::set_prediction(const RelativeFrame (&before)[2], const MotionBound& step) {
  drop_prediction();
  if (!(step.distance > kLeastDistance)) return;
  prediction_ = MotionPrediction(before, last_, *state_.tree[0], *state_.tree[1], step.distance,
                                 step.rotation_change);
  has_prediction_ = true;
}

void WideFront::drop_prediction() {
  if (!has_prediction_) return;
  has_prediction_ = false;
  // Budgets that counted on the prediction are lowered to what holds whatever the motion does.
  const float now = rounded_up(spent_);
  for (std::vector<float>* budgets : {&state_.visit_budgets, &state_.leaves_budgets}) {
    for (float& budget : *budgets) {
      if (budget > now) budget = std::min(budget, (now + kDeviation * (budget - now)) * kRoundDown);
    }
  }
}

PlacePair WideFront::places_of(std::uint32_t lane_of_leaves) const {
  const Leaves& leaves = state_.leaves[lane_of_leaves / kLeafPairs];
  const std::uint32_t lane = lane_of_leaves % kLeafPairs;
  const PlacePair places = {leaves.tested.first + lane / ChildLink::kMaxLeafSize,
                            leaves.query.first + lane % ChildLink::kMaxLeafSize};
  return leaves.tested_side == 0 ? places : PlacePair{places.b, places.a};
}

double WideFront::share_spent(const Pass& pass, double limit) const {
  const float spent = spent_at(pass, limit);
  const std::size_t all = state_.visits.size() + state_.leaves.size();
  return static_cast<double>(count_spent(state_.visit_budgets, spent) +
                             count_spent(state_.leaves_budgets, spent)) /
         static_cast<double>(all);
}

void WideFront::update(const Pass& pass, double limit, const Foresight& foresight) {
  const std::uint64_t before = state_.counts.box_tests;
  const std::uint64_t known = state_.lanes;
  const double look_ahead = std::max(limit, foresight.look_ahead);
  update_front(state_, pass,
               {.required = horizon_at(pass, limit),
                .look_ahead = horizon_at(pass, look_ahead),
                .useful = static_cast<float>(foresight.useful),
                .most_added = foresight.most_added});
  const std::uint64_t tested = state_.counts.box_tests - before;
  skipped_ += known > tested ? known - tested : 0;
}

bool WideFront::renew_budget(std::size_t index, const Pass& pass, double limit) {
  const FrontHorizon horizon = horizon_at(pass, limit);
  float& budget = state_.near_pair_budgets[index];
  if (!(budget <= horizon.spent_budget)) return true;
  const QueryBall& query = state_.distance.of_leaves[state_.near_pairs[index] / kLeafPairs].ball;
  const float gap = state_.near_pair_planes[index].gap_after(query, pass.since[query.tested_side]);
  const float later = rounded_down(pass.spent + static_cast<double>(gap));
  if (!(gap > horizon.limit && later > horizon.spent_budget)) return false;
  budget = later;
  return true;
}

void WideFront::set_gap(std::size_t index, const Pass& pass, double gap) {
  state_.near_pair_budgets[index] = rounded_down(pass.spent + gap);
}

void WideFront::keep_apart(std::size_t index, const Pass& pass, const Gap& gap) {
  set_gap(index, pass, gap.units);
  const QueryBall& query = state_.distance.of_leaves[state_.near_pairs[index] / kLeafPairs].ball;
  const bool is_b_query = query.tested_side == 0;
  double direction[3];
  for (int i = 0; i < 3; ++i)
    direction[i] = is_b_query ? gap.along_in_a[i] : -gap.along_in_b[i];
  state_.near_pair_planes[index] =
      FrontPlane(direction, gap.units, query, pass.since[query.tested_side]);
}

double WideFront::proven_gap(const Pass& pass) const {
  if (!state_.busy.empty()) return 0;
  float least = state_.least_budget;
  for (const float budget : state_.near_pair_budgets)
    least = std::min(least, budget);
  return (static_cast<double>(least) - pass.spent) * static_cast<double>(pass.deviation) -
         2 * pass.slack;
}

WideFront::Counts WideFront::take_counts() {
  const Counts counts{state_.counts, skipped_};
  state_.counts = {};
  skipped_ = 0;
  return counts;
}

}  // namespace graze::bvh

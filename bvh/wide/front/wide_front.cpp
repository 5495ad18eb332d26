#include <graze/bvh/wide/front/front_pass.h>
#include <graze/bvh/wide/front/wide_front.h>

#include <algorithm>
#include <limits>

namespace graze::bvh {
namespace {

/// A step of a course, which is divided by.
constexpr double kLeastWay = 0x1p-50;

/// Of vectors that grow.
constexpr std::size_t kFirstSize = 64;

/// What has a deadline up to it is due.
float due_at(const WideFront::Pass& pass, double limit) {
  return rounded_up(pass.moved + (limit + 2 * pass.slack) / static_cast<double>(pass.drift));
}

FrontHorizon horizon_at(const WideFront::Pass& pass, double limit) {
  return {limit > 0 ? rounded_up(limit) : 0, due_at(pass, limit)};
}

std::size_t count_due(const std::vector<float>& deadlines, float due) {
  return static_cast<std::size_t>(std::count_if(deadlines.begin(), deadlines.end(),
                                                [due](float deadline) { return deadline <= due; }));
}

}  // namespace

WideFront::Pass::Pass(const RelativeFrame& b_in_a, const RelativeFrame& a_in_b, Bounds what)
    : bounds(what),
      slack(std::max(b_in_a.slack, a_in_b.slack)),
      into{WideWay(b_in_a), WideWay(a_in_b)},
      units{static_cast<float>(b_in_a.units_a), static_cast<float>(a_in_b.units_a)} {}

void WideFront::Pass::aim_along(const double (&along)[3]) {
  const WideWay& of_a_in_b = into[1];
  for (int i = 0; i < 3; ++i) {
    direction[0][i] = static_cast<float>(along[i]);
    direction[1][i] = static_cast<float>(-(of_a_in_b.rotation[i][0] * along[0] +
                                           of_a_in_b.rotation[i][1] * along[1] +
                                           of_a_in_b.rotation[i][2] * along[2]));
  }
}

void WideFront::follow(const RelativeFrame& b_in_a, const RelativeFrame& a_in_b,
                       const Motion& motion) {
  const RelativeFrame now[2] = {b_in_a, a_in_b};
  const double way = motion.way - motion_.way;
  const double drift = has_course_ ? course_.drift(last_, now, way) : 0;
  // Should it be no number, the clock is none.
  clock_ = (clock_ + std::max(drift / static_cast<double>(kDrift), way)) * (1 + 0x1p-50);
  motion_ = motion;
  std::copy_n(now, 2, last_);
}

WideFront::Pass WideFront::pass(Bounds bounds) const {
  Pass pass(last_[0], last_[1], bounds);
  pass.moved = clock_;
  if (has_course_) {
    pass.drift = kDrift;
    pass.per_way = course_.per_way();
    for (int side = 0; side < 2; ++side)
      pass.step[side] = course_.step(side);
  }
  pass.since[0] = FrontWay(first_[0], last_[0], *state_.tree[1], motion_.turn);
  pass.since[1] = FrontWay(first_[1], last_[1], *state_.tree[0], motion_.turn);
  return pass;
}

void WideFront::begin(const WideTree& tree_a, const WideTree& tree_b, const RelativeFrame& b_in_a,
                      const RelativeFrame& a_in_b) {
  first_[0] = last_[0] = b_in_a;
  first_[1] = last_[1] = a_in_b;
  motion_ = {};
  clock_ = 0;
  has_course_ = false;
  state_.tree[0] = &tree_a;
  state_.tree[1] = &tree_b;
  state_.visits.reserve(kFirstSize);
  state_.leaves.reserve(kFirstSize);
  state_.visits.clear();
  state_.meeting.clear();
  state_.distance.clear();
  state_.visit_deadlines.clear();
  state_.leaves.clear();
  state_.leaves_deadlines.clear();
  state_.busy.clear();
  state_.candidates.clear();
  state_.candidate_deadlines.clear();
  state_.candidate_planes.clear();
  state_.lanes = 0;
}

void WideFront::set_course(const RelativeFrame (&before)[2], const Motion& step) {
  drop_course();
  if (!(step.way > kLeastWay)) return;
  course_ = FrontCourse(before, last_, *state_.tree[0], *state_.tree[1], step.way, step.turn);
  has_course_ = true;
}

void WideFront::drop_course() {
  if (!has_course_) return;
  has_course_ = false;
  // What was due later for the course's sake is no nearer than this.
  const float now = rounded_up(clock_);
  for (std::vector<float>* deadlines : {&state_.visit_deadlines, &state_.leaves_deadlines}) {
    for (float& deadline : *deadlines) {
      if (deadline > now)
        deadline = std::min(deadline, (now + kDrift * (deadline - now)) * kRoundDown);
    }
  }
}

PlacePair WideFront::places_of(std::uint32_t lane_of_leaves) const {
  const Leaves& leaves = state_.leaves[lane_of_leaves / kLeafPairs];
  const std::uint32_t lane = lane_of_leaves % kLeafPairs;
  const PlacePair places = {leaves.host.first + lane / ChildLink::kMaxLeafSize,
                            leaves.guest.first + lane % ChildLink::kMaxLeafSize};
  return leaves.host_side == 0 ? places : PlacePair{places.b, places.a};
}

double WideFront::share_due(const Pass& pass, double limit) const {
  const float due = due_at(pass, limit);
  const std::size_t all = state_.visits.size() + state_.leaves.size();
  return static_cast<double>(count_due(state_.visit_deadlines, due) +
                             count_due(state_.leaves_deadlines, due)) /
         static_cast<double>(all);
}

void WideFront::advance(const Pass& pass, double limit, const Foresight& foresight) {
  const std::uint64_t before = state_.counts.box_tests;
  const std::uint64_t known = state_.lanes;
  const double reach = std::max(limit, foresight.reach);
  pass_over(state_, pass,
            {.must = horizon_at(pass, limit),
             .reach = horizon_at(pass, reach),
             .useful = static_cast<float>(foresight.useful),
             .most_added = foresight.most_added});
  const std::uint64_t tested = state_.counts.box_tests - before;
  skipped_ += known > tested ? known - tested : 0;
}

bool WideFront::is_due(std::size_t index, const Pass& pass, double limit) {
  const FrontHorizon horizon = horizon_at(pass, limit);
  float& deadline = state_.candidate_deadlines[index];
  if (!(deadline <= horizon.due)) return false;
  const FrontGuest& guest = state_.distance.of_leaves[state_.candidates[index] / kLeafPairs].guest;
  const float gap = state_.candidate_planes[index].gap_after(guest, pass.since[guest.host_side]);
  const float later = rounded_down(pass.moved + static_cast<double>(gap));
  if (!(gap > horizon.limit && later > horizon.due)) return true;
  deadline = later;
  return false;
}

void WideFront::set_gap(std::size_t index, const Pass& pass, double gap) {
  state_.candidate_deadlines[index] = rounded_down(pass.moved + gap);
}

void WideFront::keep_apart(std::size_t index, const Pass& pass, const Gap& gap) {
  set_gap(index, pass, gap.units);
  const FrontGuest& guest = state_.distance.of_leaves[state_.candidates[index] / kLeafPairs].guest;
  const bool is_b_guest = guest.host_side == 0;
  double direction[3];
  for (int i = 0; i < 3; ++i)
    direction[i] = is_b_guest ? gap.along_in_a[i] : -gap.along_in_b[i];
  state_.candidate_planes[index] =
      FrontPlane(direction, gap.units, guest, pass.since[guest.host_side]);
}

double WideFront::proven_gap(const Pass& pass) const {
  if (!state_.busy.empty()) return 0;
  float least = state_.least_deadline;
  for (const float deadline : state_.candidate_deadlines)
    least = std::min(least, deadline);
  return (static_cast<double>(least) - pass.moved) * static_cast<double>(pass.drift) -
         2 * pass.slack;
}

WideFront::Counts WideFront::take_counts() {
  const Counts counts{state_.counts, skipped_};
  state_.counts = {};
  skipped_ = 0;
  return counts;
}

}  // namespace graze::bvh

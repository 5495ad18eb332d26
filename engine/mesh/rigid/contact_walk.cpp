#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/rigid/box_direction.h>
#include <graze/engine/mesh/rigid/contact_walk.h>
#include <graze/engine/mesh/rigid/keeps_apart.h>
#include <graze/engine/mesh/rigid/near_triangles.h>

#include <algorithm>

namespace graze {
namespace {

/// The share of the time that is left at which narrowing ends: what is nearer to a contact than
/// that is for the walk to look at.
constexpr std::uint64_t kNarrowEnough = 1 << 14;

}  // namespace

std::uint64_t ContactWalk::run() {
  open_.push({0, 0, pair_.grid().whole(), false, {}});
  while (!open_.empty() && !is_out_of_budget_) {
    const Visit next = open_.pop();
    if (next.cell.first < low_) visit(next);
    if (end_ == End::AtAny && low_ < pair_.grid().end()) return low_;
  }
  while (!open_.empty())
    unproved_ = std::min(unproved_, open_.pop().cell.first);
  is_out_of_budget_ = unproved_ < low_;
  return std::min(low_, unproved_);
}

TimeSpan ContactWalk::before_low(const TimeCell& cell) const {
  // In the last step nothing moves far enough to come from beyond the limit to a contact.
  const bool is_beyond = low_ < pair_.grid().end() && cell.last() >= low_;
  return {cell.first, is_beyond ? low_ - 1 : cell.last()};
}

void ContactWalk::find_near(std::uint64_t time) {
  low_ = time;
  if (end_ == End::AtAny || is_narrowed_) return;
  // At a few times the meshes are asked whether they meet: what is later than such a contact need
  // not be looked at, and most often a few steps before it is the answer. Without this what hits
  // takes twice as long, and three times with distances in place of a yes or no.
  is_narrowed_ = true;
  std::uint64_t before = 0;
  while (low_ > before + 1 + before / kNarrowEnough) {
    const std::uint64_t middle = before + (low_ - before) / 2;
    const PlacedBodies& placed = pair_.at(middle);
    const bool is_hit =
        intersects({pair_.a().mesh, placed.pose_a}, {pair_.b().mesh, placed.pose_b}, &work_);
    (is_hit ? low_ : before) = middle;
  }
}

bool ContactWalk::spend() {
  is_out_of_budget_ = is_out_of_budget_ || budget_ == 0;
  if (!is_out_of_budget_) --budget_;
  return !is_out_of_budget_;
}

void ContactWalk::visit(const Visit& visit) {
  if (!spend()) {
    unproved_ = std::min(unproved_, visit.cell.first);
    return;
  }
  const BodyBox &a = boxes_a_.of(visit.a), &b = boxes_b_.of(visit.b);
  const TimeSpan span = before_low(visit.cell);
  ++work_.volume_tests;
  Visit next = visit;
  const auto is_apart = [&] {
    return keeps_apart(pair_, span, next.direction, a, b) == Apart::Always;
  };
  bool is_proved = visit.has_direction && is_apart();
  if (!is_proved) {
    const std::uint64_t middle = span.first + (span.last - span.first) / 2;
    AxisSearch axes(pair_.at(middle), a, b, pair_.sure_limit());
    next.has_direction = axes.try_faces(next.direction);
    is_proved = next.has_direction && is_apart();
    if (!is_proved && axes.try_edges(next.direction)) {
      next.has_direction = true;
      is_proved = is_apart();
    }
  }
  work_.volume_rejections += is_proved;
  if (is_proved && record_ != nullptr) record_->add_plane(next.direction.n);
  if (!is_proved) open(next, span, a, b);
}

bool ContactWalk::are_both_opened(const bvh::Node& a, const bvh::Node& b, double size_a,
                                  double size_b) const {
  return record_ == nullptr && !a.is_leaf() && !b.is_leaf() && size_a < 2 * size_b &&
         size_b < 2 * size_a;
}

void ContactWalk::open(const Visit& visit, const TimeSpan& span, const BodyBox& box_a,
                       const BodyBox& box_b) {
  const bvh::Node& a = pair_.a().tree.nodes[visit.a];
  const bvh::Node& b = pair_.b().tree.nodes[visit.b];
  if (a.is_leaf() && b.is_leaf()) return visit_leaves(visit);
  const double size_a = a.is_leaf() ? -1 : box_a.size();
  const double size_b = b.is_leaf() ? -1 : box_b.size();
  // Nodes that move further than they are large are divided in time, as they are known better after
  // half of it; others are opened, and rather so if their boxes meet halfway. As measured, with
  // twice or half of these shares a nut on its bolt takes up to a half longer.
  const double share = visit.has_direction ? 1 : 4;
  const double travel = pair_.displacement(span, box_a.radius, box_b.radius);
  const double room = share * std::max(size_a, size_b);
  const bool is_fast = travel > room;
  Visit one = visit, other = visit;
  if (is_fast && !visit.cell.is_finest()) {
    one.cell = visit.cell.earlier();
    other.cell = visit.cell.later();
    if (record_ != nullptr) record_->halve_time();
  } else if (are_both_opened(a, b, size_a, size_b) && 2 * travel < room) {
    // Of these visits mostly neither box alone would do; where time is halved soon it pays to wait.
    // A record has one step at a time.
    for (std::uint32_t i = 2; i-- > 0;) {
      for (std::uint32_t j = 2; j-- > 0;) {
        one.a = a.first + i;
        one.b = b.first + j;
        open_.push(one);
      }
    }
    return;
  } else if (size_a > size_b) {
    one.a = a.first;
    other.a = a.first + 1;
    if (record_ != nullptr) record_->divide_a(a.first);
  } else {
    one.b = b.first;
    other.b = b.first + 1;
    if (record_ != nullptr) record_->divide_b(b.first);
  }
  open_.push(other);
  open_.push(one);
}

void ContactWalk::visit_leaves(const Visit& visit) {
  const bvh::Tree &tree_a = pair_.a().tree, &tree_b = pair_.b().tree;
  const bvh::Node& a = tree_a.nodes[visit.a];
  const bvh::Node& b = tree_b.nodes[visit.b];
  for (std::uint32_t i = a.first; i < a.first + a.count; ++i) {
    if (record_ != nullptr && i + 1 < a.first + a.count) record_->divide_a_after(1);
    for (std::uint32_t j = b.first; j < b.first + b.count; ++j) {
      if (record_ != nullptr && j + 1 < b.first + b.count) record_->divide_b_after(1);
      decide({tree_a.primitives[i], tree_b.primitives[j]},
             {visit.cell, visit.has_direction, visit.direction});
    }
  }
}

void ContactWalk::decide(TrianglePair of_bodies, const DirectedCell& whole) {
  MovingTriangles triangles(pair_, of_bodies, work_);
  bvh::TraversalStack<DirectedCell, 64> open;
  open.push(whole);
  while (!open.empty()) {
    DirectedCell next = open.pop();
    TimeCell& cell = next.cell;
    while (!cell.is_finest() && cell.middle() >= low_)
      cell = cell.earlier();
    if (cell.first >= low_) continue;
    if (!spend()) {
      unproved_ = std::min(unproved_, cell.first);
      return;
    }
    const TimeSpan span = before_low(cell);
    Apart answer = next.has_direction ? triangles.ask(span, next.direction) : Apart::Unsure;
    if (answer == Apart::Unsure || (cell.is_finest() && answer == Apart::AtEnds)) {
      next.has_direction = true;
      const std::uint64_t middle = span.first + (span.last - span.first) / 2;
      if (triangles.are_apart_by_normals(span, middle, next.direction)) {
        answer = Apart::Always;
      } else if (triangles.is_near(middle, next.direction)) {
        find_near(middle);
        next.has_direction = false;
      } else if (!cell.is_finest()) {
        answer = triangles.ask(span, next.direction);
      }
    }
    if (cell.is_finest() || answer == Apart::Always) {
      if (record_ != nullptr) record_->add_plane(next.direction.n);
      continue;
    }
    if (record_ != nullptr) record_->halve_time();
    open.push({cell.later(), next.has_direction, next.direction});
    open.push({cell.earlier(), next.has_direction, next.direction});
  }
}

}  // namespace graze

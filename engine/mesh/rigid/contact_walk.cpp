#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/rigid/contact_walk.h>
#include <graze/narrowphase/derived/distance_stages.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

double dot(const double* n, const Eigen::Vector3d& p) {
  return (n[0] * p.data()[0] + n[1] * p.data()[1]) + n[2] * p.data()[2];
}

double end_along(const double* n, const Triangle& triangle) {
  return std::max(dot(n, triangle.a), std::max(dot(n, triangle.b), dot(n, triangle.c)));
}

double start_along(const double* n, const Triangle& triangle) {
  return std::min(dot(n, triangle.a), std::min(dot(n, triangle.b), dot(n, triangle.c)));
}

double size_of(const MetricBox& box) {
  return std::max(box.half[0], std::max(box.half[1], box.half[2]));
}

}  // namespace

std::uint64_t ContactWalk::run(End end) {
  open_.push({0, 0, pair_.grid().whole()});
  while (!open_.empty() && !is_out_of_budget_) {
    const Visit next = open_.pop();
    if (next.cell.first < low_) visit(next);
    if (end == End::AtFirst && low_ < pair_.grid().end()) return low_;
  }
  while (!open_.empty())
    unproved_ = std::min(unproved_, open_.pop().cell.first);
  is_out_of_budget_ = unproved_ < low_;
  return std::min(low_, unproved_);
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
  const MovingBody &a = pair_.a(), &b = pair_.b();
  const MetricBox box_a = pair_.box_a(a.tree.nodes[visit.a].box);
  const MetricBox box_b = pair_.box_b(b.tree.nodes[visit.b].box);
  const TimeCell& cell = visit.cell;
  ++work_.volume_tests;
  const double radius_a = a.radius_of(box_a), radius_b = b.radius_of(box_b);
  ApartDirection direction;
  const std::uint64_t middle = cell.first + cell.length() / 2;
  if (pair_.find_direction(middle, box_a, box_b, direction) &&
      pair_.are_apart(cell, direction, box_a, box_b,
                      a.turned * a.turned * radius_a + b.turned * b.turned * radius_b)) {
    ++work_.volume_rejections;
    return;
  }
  open(visit, box_a, box_b, radius_a, radius_b);
}

void ContactWalk::open(const Visit& visit, const MetricBox& box_a, const MetricBox& box_b,
                       double radius_a, double radius_b) {
  const bvh::Node& a = pair_.a().tree.nodes[visit.a];
  const bvh::Node& b = pair_.b().tree.nodes[visit.b];
  const bool are_leaves = a.is_leaf() && b.is_leaf();
  const double size_a = a.is_leaf() ? 0 : size_of(box_a);
  const double size_b = b.is_leaf() ? 0 : size_of(box_b);
  // What moves further than it is large is known better after half of the time, else its parts are.
  const double size = are_leaves ? 0 : std::max(size_a, size_b);
  const TimeCell& cell = visit.cell;
  if (!are_leaves && !cell.is_finest() && pair_.displacement(cell, radius_a, radius_b) > 4 * size) {
    open_.push({visit.a, visit.b, cell.later()});
    open_.push({visit.a, visit.b, cell.earlier()});
  } else if (are_leaves) {
    visit_leaves(visit);
  } else if (b.is_leaf() || (!a.is_leaf() && size_a > size_b)) {
    open_.push({a.first + 1, visit.b, cell});
    open_.push({a.first, visit.b, cell});
  } else {
    open_.push({visit.a, b.first + 1, cell});
    open_.push({visit.a, b.first, cell});
  }
}

void ContactWalk::visit_leaves(const Visit& visit) {
  const bvh::Tree &tree_a = pair_.a().tree, &tree_b = pair_.b().tree;
  const bvh::Node& a = tree_a.nodes[visit.a];
  const bvh::Node& b = tree_b.nodes[visit.b];
  for (std::uint32_t i = a.first; i < a.first + a.count; ++i) {
    for (std::uint32_t j = b.first; j < b.first + b.count; ++j)
      decide({tree_a.primitives[i], tree_b.primitives[j]}, visit.cell);
  }
}

void ContactWalk::decide(TrianglePair pair, TimeCell whole) {
  const MovingBody &a = pair_.a(), &b = pair_.b();
  const double bulges = a.turned * a.turned * a.radius_of(a.mesh.triangle(pair.a)) +
                        b.turned * b.turned * b.radius_of(b.mesh.triangle(pair.b));
  bvh::TraversalStack<TimeCell, 64> open;
  open.push(whole);
  while (!open.empty()) {
    const TimeCell cell = open.pop();
    if (cell.first >= low_) continue;
    if (!spend()) {
      unproved_ = std::min(unproved_, cell.first);
      return;
    }
    const std::uint64_t middle = cell.first + cell.length() / 2;
    ApartDirection direction;
    if (middle >= low_) {
      open.push(cell.earlier());
    } else if (is_near(pair, middle, direction)) {
      low_ = middle;
      if (!cell.is_finest()) open.push(cell.earlier());
    } else if (!cell.is_finest() && !are_apart(pair, cell, direction, bulges)) {
      open.push(cell.later());
      open.push(cell.earlier());
    }
  }
}

bool ContactWalk::is_near(TrianglePair pair, std::uint64_t time, ApartDirection& direction) {
  const PlacedBodies& placed = pair_.at(time);
  const narrowphase::StagedDistance found = narrowphase::decide_distance(
      narrowphase::place(placed.pose_a, pair_.a().mesh.triangle(pair.a)),
      narrowphase::place(placed.pose_b, pair_.b().mesh.triangle(pair.b)));
  ++work_.triangle_tests;
  work_.exact_tests += found.stage == narrowphase::Stage::Exact;
  const double distance = found.result.distance;
  if (distance <= pair_.limit()) return true;
  for (int i = 0; i < 3; ++i) {
    direction.n[i] = (found.result.point_b.data()[i] - found.result.point_a.data()[i]) / distance;
  }
  return false;
}

bool ContactWalk::are_apart(TrianglePair pair, const TimeCell& cell,
                            const ApartDirection& direction, double bulges) {
  const Triangle a = pair_.a().mesh.triangle(pair.a);
  const Triangle b = pair_.b().mesh.triangle(pair.b);
  const double least = pair_.margin(cell, bulges);
  for (const std::uint64_t time : {cell.first, cell.last()}) {
    const PlacedBodies& placed = pair_.at(time);
    const double end = end_along(direction.n, narrowphase::place(placed.pose_a, a));
    const double start = start_along(direction.n, narrowphase::place(placed.pose_b, b));
    if (!(start - end > least)) return false;
  }
  return true;
}

}  // namespace graze

#include <graze/engine/world/bodies/islands.h>
#include <graze/engine/world/bodies/pair_news.h>

#include <utility>

namespace graze {

void Islands::make_room(std::size_t bodies, std::size_t more_touches) {
  if (more_touches > free_touches_) make_room_in(halves_, 2 * (more_touches - free_touches_));
  if (bodies <= nodes_.size()) return;
  const std::size_t more = bodies - nodes_.size();
  make_room_in(nodes_, more), make_room_in(islands_, more), make_room_in(queue_, more);
  for (auto i = static_cast<std::uint32_t>(nodes_.size()); i < bodies; ++i) {
    islands_.push_back({free_island_, 0});
    free_island_ = i;
  }
  nodes_.resize(bodies);
  queue_.resize(bodies);
}

void Islands::open_island(std::uint32_t body) {
  const std::uint32_t island = free_island_;
  free_island_ = islands_[island].first;
  islands_[island] = {body, 1};
  Node& node = nodes_[body];
  node.island = island;
  node.next = node.previous = body;
}

void Islands::close_island(std::uint32_t island) {
  islands_[island] = {free_island_, 0};
  free_island_ = island;
}

void Islands::add(std::uint32_t body) {
  open_island(body);
}

void Islands::remove(std::uint32_t body) {
  while (nodes_[body].first_edge != kNone)
    disconnect(body, halves_[nodes_[body].first_edge].other);
  close_island(nodes_[body].island);
  nodes_[body].island = kNone;
}

/// Returns the half of their edge that `a` sees. Looks through the edges of the body that has
/// fewer.
std::uint32_t Islands::find(std::uint32_t a, std::uint32_t b) const {
  const bool is_of_a = nodes_[a].degree <= nodes_[b].degree;
  const std::uint32_t other = is_of_a ? b : a;
  for (std::uint32_t half = nodes_[is_of_a ? a : b].first_edge; half != kNone;
       half = halves_[half].next) {
    if (halves_[half].other == other) return is_of_a ? half : half ^ 1;
  }
  return kNone;
}

void Islands::link(std::uint32_t half, std::uint32_t body, std::uint32_t other) {
  Node& node = nodes_[body];
  halves_[half] = {other, node.first_edge, kNone};
  if (node.first_edge != kNone) halves_[node.first_edge].previous = half;
  node.first_edge = half;
  ++node.degree;
}

void Islands::unlink(std::uint32_t half, std::uint32_t body) {
  const auto [other, next, previous] = halves_[half];
  if (next != kNone) halves_[next].previous = previous;
  (previous != kNone ? halves_[previous].next : nodes_[body].first_edge) = next;
  --nodes_[body].degree;
}

void Islands::connect(std::uint32_t a, std::uint32_t b) {
  if (find(a, b) != kNone) return;
  std::uint32_t half = free_touch_;
  if (half != kNone) {
    free_touch_ = halves_[half].next;
    --free_touches_;
  } else {
    half = static_cast<std::uint32_t>(halves_.size());
    halves_.resize(halves_.size() + 2);
  }
  link(half, a, b), link(half + 1, b, a);
  if (nodes_[a].island != nodes_[b].island) merge(nodes_[a].island, nodes_[b].island);
}

void Islands::merge(std::uint32_t a, std::uint32_t b) {
  if (islands_[a].size < islands_[b].size) std::swap(a, b);
  const std::uint32_t of_a = islands_[a].first, of_b = islands_[b].first;
  std::uint32_t body = of_b;
  do {
    nodes_[body].island = a;
    body = nodes_[body].next;
  } while (body != of_b);
  // Two rings become one when two of their links change places.
  const std::uint32_t last_a = nodes_[of_a].previous, last_b = nodes_[of_b].previous;
  nodes_[last_a].next = of_b, nodes_[of_b].previous = last_a;
  nodes_[last_b].next = of_a, nodes_[of_a].previous = last_b;
  work_.steps += islands_[b].size;
  ++work_.merged;
  islands_[a].size += islands_[b].size;
  close_island(b);
}

void Islands::disconnect(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t half = find(a, b);
  if (half == kNone) return;
  unlink(half, a), unlink(half ^ 1, b);
  const std::uint32_t first = half & ~std::uint32_t{1};
  halves_[first].next = free_touch_;
  free_touch_ = first;
  ++free_touches_;
  split_if_apart(a, b);
}

void Islands::see(Side& side, std::uint32_t body) {
  nodes_[body].stamp = side.stamp;
  queued(side, side.seen++) = body;
}

/// Sees the bodies that touch the next body of a side. True if the other side has seen one of them.
bool Islands::meets_other(Side& side) {
  const std::uint32_t body = queued(side, side.asked++);
  for (std::uint32_t half = nodes_[body].first_edge; half != kNone; half = halves_[half].next) {
    ++work_.steps;
    const std::uint32_t other = halves_[half].other;
    if (nodes_[other].stamp == (side.stamp ^ 1)) return true;
    if (nodes_[other].stamp != side.stamp) see(side, other);
  }
  return false;
}

void Islands::split_if_apart(std::uint32_t a, std::uint32_t b) {
  if (last_stamp_ >= kNone - 2) {
    for (Node& node : nodes_)
      node.stamp = 0;
    last_stamp_ = 0;
  }
  last_stamp_ += 2;
  Side of_a{last_stamp_}, of_b{last_stamp_ + 1};
  see(of_a, a), see(of_b, b);
  for (;;) {
    if (of_a.asked == of_a.seen) return split_off(of_a, b);
    if (meets_other(of_a)) return;
    if (of_b.asked == of_b.seen) return split_off(of_b, a);
    if (meets_other(of_b)) return;
  }
}

/// Makes an island of all bodies that a side has seen. The body `stays` keeps the old island.
void Islands::split_off(const Side& side, std::uint32_t stays) {
  Island& rest = islands_[nodes_[stays].island];
  rest.first = stays;
  rest.size -= side.seen;
  const std::uint32_t first = queued(side, 0);
  for (std::uint32_t i = 0; i < side.seen; ++i) {
    const std::uint32_t body = queued(side, i);
    Node& node = nodes_[body];
    nodes_[node.previous].next = node.next;
    nodes_[node.next].previous = node.previous;
    if (i == 0) {
      open_island(body);
      continue;
    }
    const std::uint32_t last = nodes_[first].previous;
    node.island = nodes_[first].island;
    node.previous = last, node.next = first;
    nodes_[last].next = nodes_[first].previous = body;
  }
  islands_[nodes_[first].island].size = side.seen;
  work_.steps += side.seen;
  ++work_.split;
}

void Islands::list(std::uint32_t body, std::vector<std::uint32_t>& into) const {
  into.reserve(into.size() + islands_[nodes_[body].island].size);
  std::uint32_t next = body;
  do {
    into.push_back(next);
    next = nodes_[next].next;
  } while (next != body);
}

IslandWork Islands::take_work() {
  return std::exchange(work_, {});
}

}  // namespace graze

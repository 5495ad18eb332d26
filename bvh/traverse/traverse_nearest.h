#pragma once

#include <graze/bvh/traverse/traversal.h>
#include <graze/bvh/tree/tree.h>

#include <cstdint>
#include <utility>

namespace graze::bvh {

/// Depth-first branch and bound: calls `leaf_fn(const Node&)` for leaves, roughly from near to far,
/// until it returns Walk::Stop. Returns whether it did. Of the children of a node the one with the
/// lower bound is walked first, so that what its leaves show prunes the other.
///
/// `bounds` speaks of nodes by their indices: `of(node)` is a number that no answer below the node
/// is under; `is_missed(bound)` drops a node as soon as it is found, and `is_beyond(bound)` when
/// its turn comes, by when leaf_fn may have lowered the limit.
template <typename Bounds, typename LeafFn>
Walk traverse_nearest(const Tree& tree, Bounds&& bounds, LeafFn&& leaf_fn) {
  struct Waiting {
    std::uint32_t node;
    double bound;
  };
  TraversalStack<Waiting, 128> open;
  const double at_root = bounds.of(0);
  if (!bounds.is_missed(at_root)) open.push({0, at_root});
  while (!open.empty()) {
    const Waiting top = open.pop();
    if (bounds.is_beyond(top.bound)) continue;
    const Node& node = tree.nodes[top.node];
    if (node.is_leaf()) {
      if (leaf_fn(node) == Walk::Stop) return Walk::Stop;
      continue;
    }
    Waiting near{node.first, bounds.of(node.first)};
    Waiting far{node.first + 1, bounds.of(node.first + 1)};
    if (far.bound < near.bound) std::swap(near, far);
    if (!bounds.is_missed(far.bound)) open.push(far);
    if (!bounds.is_missed(near.bound)) open.push(near);
  }
  return Walk::Continue;
}

}  // namespace graze::bvh

#pragma once

#include <graze/bvh/traversal.h>
#include <graze/bvh/tree.h>

namespace graze::bvh {

/// Calls `leaf_fn(const Node& a, const Node& b)` for the pairs of different leaves, each unordered
/// pair once, that `are_apart(a, b)` does not prune, nor any pair above them, and with a and b the
/// same node for each leaf, until it returns Walk::Stop. Returns whether it did.
template <typename Apart, typename LeafFn>
Walk traverse_self(const Tree& tree, Apart&& are_apart, LeafFn&& leaf_fn) {
  PairStack open;
  open.push({0, 0});
  while (!open.empty()) {
    const NodePair pair = open.pop();
    const Node& a = tree.nodes[pair.a];
    const Node& b = tree.nodes[pair.b];
    const bool is_same = pair.a == pair.b;
    if (!is_same && are_apart(a, b)) continue;
    if (a.is_leaf() && b.is_leaf()) {
      if (leaf_fn(a, b) == Walk::Stop) return Walk::Stop;
    } else if (is_same) {
      open.push({a.first, a.first + 1});
      open.push({a.first + 1, a.first + 1});
      open.push({a.first, a.first});
    } else if (b.is_leaf() || (!a.is_leaf() && half_surface(a.box) >= half_surface(b.box))) {
      open_first(open, pair, a.first);
    } else {
      open_second(open, pair, b.first);
    }
  }
  return Walk::Continue;
}

}  // namespace graze::bvh

#pragma once

#include <graze/bvh/traverse/traversal.h>
#include <graze/bvh/tree/tree.h>

namespace graze::bvh {

/// Calls `leaf_fn(const Node& a, const Node& b)` for the pairs of different leaves, each unordered
/// pair once, that `separation` does not prune, nor any pair above them, and with a and b the same
/// node for each leaf, until it returns Walk::Stop. Returns whether it did. The separation is what
/// traverse_pair() asks.
template <typename Separation, typename LeafFn>
Walk traverse_self(const Tree& tree, Separation&& separation, LeafFn&& leaf_fn) {
  PairStack open;
  open.push({0, 0});
  while (!open.empty()) {
    const NodePair pair = open.pop();
    const bool is_same = pair.a == pair.b;
    if (!is_same && separation.are_apart(pair.a, pair.b)) continue;
    const Node& a = tree.nodes[pair.a];
    const Node& b = tree.nodes[pair.b];
    if (a.is_leaf() && b.is_leaf()) {
      if (leaf_fn(a, b) == Walk::Stop) return Walk::Stop;
    } else if (is_same) {
      open.push({a.first, a.first + 1});
      open.push({a.first + 1, a.first + 1});
      open.push({a.first, a.first});
    } else if (b.is_leaf() || (!a.is_leaf() && separation.is_first_larger(pair.a, pair.b))) {
      open_first(open, pair, a.first);
    } else {
      open_second(open, pair, b.first);
    }
  }
  return Walk::Continue;
}

}  // namespace graze::bvh

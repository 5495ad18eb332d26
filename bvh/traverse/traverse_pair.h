#pragma once

#include <graze/bvh/traverse/traversal.h>
#include <graze/bvh/tree/tree.h>

namespace graze::bvh {

/// Calls `leaf_fn(const Node& a, const Node& b)` for the pairs of leaves that `separation` does not
/// prune, nor any pair above them, until it returns Walk::Stop. Returns whether it did. The
/// separation speaks of nodes by their indices: `are_apart(a, b)` prunes, and of two inner nodes
/// the one is opened for which `is_first_larger(a, b)` speaks.
template <typename Separation, typename LeafFn>
Walk traverse_pair(const Tree& tree_a, const Tree& tree_b, Separation&& separation,
                   LeafFn&& leaf_fn) {
  PairStack open;
  open.push({0, 0});
  while (!open.empty()) {
    const NodePair pair = open.pop();
    if (separation.are_apart(pair.a, pair.b)) continue;
    const Node& a = tree_a.nodes[pair.a];
    const Node& b = tree_b.nodes[pair.b];
    if (a.is_leaf() && b.is_leaf()) {
      if (leaf_fn(a, b) == Walk::Stop) return Walk::Stop;
    } else if (b.is_leaf() || (!a.is_leaf() && separation.is_first_larger(pair.a, pair.b))) {
      open_first(open, pair, a.first);
    } else {
      open_second(open, pair, b.first);
    }
  }
  return Walk::Continue;
}

}  // namespace graze::bvh

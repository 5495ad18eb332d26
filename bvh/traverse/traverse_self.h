#pragma once

#include <graze/bvh/traverse/traversal.h>
#include <graze/bvh/tree/tree.h>

#include <cstdint>

namespace graze::bvh {

/// Calls `end_fn(std::uint32_t a, std::uint32_t b)` for the pairs of different nodes at which the
/// walk ends, each unordered pair once, that `separation` does not prune, nor any pair above them,
/// and with a and b the same for each such node, until it returns Walk::Stop. Returns whether it
/// did. `is_end(std::uint32_t)` is true of some node on each path down, of leaves at the latest.
/// The separation is what traverse_pair() asks.
template <typename Separation, typename IsEnd, typename EndFn>
Walk traverse_self(const Tree& tree, Separation&& separation, IsEnd&& is_end, EndFn&& end_fn) {
  PairStack open;
  open.push({0, 0});
  while (!open.empty()) {
    const NodePair pair = open.pop();
    const bool is_same = pair.a == pair.b;
    if (!is_same && separation.are_apart(pair.a, pair.b)) continue;
    const Node& a = tree.nodes[pair.a];
    const Node& b = tree.nodes[pair.b];
    const bool is_a_end = is_end(pair.a), is_b_end = is_end(pair.b);
    if (is_a_end && is_b_end) {
      if (end_fn(pair.a, pair.b) == Walk::Stop) return Walk::Stop;
    } else if (is_same) {
      open.push({a.first, a.first + 1});
      open.push({a.first + 1, a.first + 1});
      open.push({a.first, a.first});
    } else if (is_b_end || (!is_a_end && separation.is_first_larger(pair.a, pair.b))) {
      open_first(open, pair, a.first);
    } else {
      open_second(open, pair, b.first);
    }
  }
  return Walk::Continue;
}

/// The same for leaves: `leaf_fn(const Node& a, const Node& b)`.
template <typename Separation, typename LeafFn>
Walk traverse_self(const Tree& tree, Separation&& separation, LeafFn&& leaf_fn) {
  return traverse_self(
      tree, separation, [&](std::uint32_t node) { return tree.nodes[node].is_leaf(); },
      [&](std::uint32_t a, std::uint32_t b) { return leaf_fn(tree.nodes[a], tree.nodes[b]); });
}

}  // namespace graze::bvh

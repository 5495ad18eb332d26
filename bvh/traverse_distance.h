#pragma once

#include <graze/bvh/traversal.h>
#include <graze/bvh/tree.h>
#include <utility>

namespace graze::bvh {

/// Two nodes that wait, with a lower bound of their distance.
struct BoundedPair {
  std::uint32_t a;
  std::uint32_t b;
  double bound;
};

/// Calls `leaf_fn(std::uint32_t a, std::uint32_t b)` with pairs of leaves by index, nearer ones
/// first as far as `bound(a, b)` of the nodes tells, until it answers Walk::Stop. A pair is skipped
/// when `is_beyond(its bound)`, which is asked again when its turn comes, for by then leaves may
/// have brought the limit down. Of two inner nodes the one is opened for which `is_first_larger(a,
/// b)` speaks. Depth first: the memory is that of the trees' heights.
template <typename Bound, typename IsBeyond, typename IsFirstLarger, typename LeafFn>
Walk traverse_distance(const Tree& tree_a, const Tree& tree_b, Bound&& bound, IsBeyond&& is_beyond,
                       IsFirstLarger&& is_first_larger, LeafFn&& leaf_fn) {
  TraversalStack<BoundedPair, 256> open;
  const auto bounded = [&](std::uint32_t a, std::uint32_t b) {
    return BoundedPair{a, b, bound(tree_a.nodes[a], tree_b.nodes[b])};
  };
  open.push(bounded(0, 0));
  while (!open.empty()) {
    const BoundedPair pair = open.pop();
    if (is_beyond(pair.bound)) continue;
    const Node& a = tree_a.nodes[pair.a];
    const Node& b = tree_b.nodes[pair.b];
    if (a.is_leaf() && b.is_leaf()) {
      if (leaf_fn(pair.a, pair.b) == Walk::Stop) return Walk::Stop;
      continue;
    }
    const bool is_a_opened = b.is_leaf() || (!a.is_leaf() && is_first_larger(a, b));
    BoundedPair near = is_a_opened ? bounded(a.first, pair.b) : bounded(pair.a, b.first);
    BoundedPair far = is_a_opened ? bounded(a.first + 1, pair.b) : bounded(pair.a, b.first + 1);
    if (far.bound < near.bound) std::swap(near, far);
    if (!is_beyond(far.bound)) open.push(far);
    if (!is_beyond(near.bound)) open.push(near);
  }
  return Walk::Continue;
}

}  // namespace graze::bvh

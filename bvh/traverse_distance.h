#pragma once

#include <graze/bvh/box_distance.h>
#include <graze/bvh/traversal.h>
#include <graze/bvh/tree.h>
#include <utility>

namespace graze::bvh {

/// How much the distance of centres counts beside a lower bound in choosing what to look at first.
inline constexpr double kCentreWeight = 0.1;

/// Two nodes that wait, with what their boxes say.
struct BoundedPair {
  std::uint32_t a;
  std::uint32_t b;
  BoxGap gap;
};

/// Which of two pairs promises less distance: centres tell where bounds do not.
inline bool is_nearer(const BoxGap& gap, const BoxGap& other) {
  return gap.squared_lower_bound + kCentreWeight * gap.squared_between_centres <
         other.squared_lower_bound + kCentreWeight * other.squared_between_centres;
}

/// Calls `leaf_fn(std::uint32_t a, std::uint32_t b)` with pairs of leaves by index, nearer ones
/// first as far as `bound(a, b)` of the nodes tells, until it answers Walk::Stop. A pair is skipped
/// when `is_beyond(its bound)`, which is asked again when its turn comes, for by then leaves may
/// have brought the limit down. Of two inner nodes the one is opened for which `is_first_larger(a,
/// b)` speaks. Depth first: the memory is that of the trees' heights.
template <typename GapOf, typename IsBeyond, typename IsFirstLarger, typename LeafFn>
Walk traverse_distance(const Tree& tree_a, const Tree& tree_b, GapOf&& gap_of, IsBeyond&& is_beyond,
                       IsFirstLarger&& is_first_larger, LeafFn&& leaf_fn) {
  TraversalStack<BoundedPair, 256> open;
  const auto bounded = [&](std::uint32_t a, std::uint32_t b) {
    return BoundedPair{a, b, gap_of(tree_a.nodes[a], tree_b.nodes[b])};
  };
  open.push(bounded(0, 0));
  while (!open.empty()) {
    const BoundedPair pair = open.pop();
    if (is_beyond(pair.gap.squared_lower_bound)) continue;
    const Node& a = tree_a.nodes[pair.a];
    const Node& b = tree_b.nodes[pair.b];
    if (a.is_leaf() && b.is_leaf()) {
      if (leaf_fn(pair.a, pair.b) == Walk::Stop) return Walk::Stop;
      continue;
    }
    const bool is_a_opened = b.is_leaf() || (!a.is_leaf() && is_first_larger(a, b));
    BoundedPair near = is_a_opened ? bounded(a.first, pair.b) : bounded(pair.a, b.first);
    BoundedPair far = is_a_opened ? bounded(a.first + 1, pair.b) : bounded(pair.a, b.first + 1);
    if (is_nearer(far.gap, near.gap)) std::swap(near, far);
    if (!is_beyond(far.gap.squared_lower_bound)) open.push(far);
    if (!is_beyond(near.gap.squared_lower_bound)) open.push(near);
  }
  return Walk::Continue;
}

}  // namespace graze::bvh

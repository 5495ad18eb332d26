#pragma once

#include <graze/bvh/traverse/traversal.h>
#include <graze/bvh/tree/tree.h>
#include <cstdint>
#include <span>

namespace graze::bvh {

/// A cut is a set of nodes of which none lies above another. This walks down from the nodes of a
/// cut and calls `node_fn(index)` for the first nodes on the way that are leaves or of which
/// `is_fine(index)` is true, but for those that `are_apart(index)` prunes with all below them,
/// until it returns Walk::Stop. Returns whether it did. What it calls node_fn for is again a cut.
template <typename Apart, typename IsFine, typename NodeFn>
Walk traverse_cut(const Tree& tree, std::span<const std::uint32_t> cut, Apart&& are_apart,
                  IsFine&& is_fine, NodeFn&& node_fn) {
  TraversalStack<std::uint32_t, 128> open;
  for (const std::uint32_t top : cut) {
    open.push(top);
    while (!open.empty()) {
      const std::uint32_t index = open.pop();
      if (are_apart(index)) continue;
      const Node& node = tree.nodes[index];
      if (node.is_leaf() || is_fine(index)) {
        if (node_fn(index) == Walk::Stop) return Walk::Stop;
        continue;
      }
      open.push(node.first + 1);
      open.push(node.first);
    }
  }
  return Walk::Continue;
}

}  // namespace graze::bvh

#pragma once

#include <graze/bvh/traverse/traversal.h>
#include <graze/bvh/tree/tree.h>
#include <cstdint>

namespace graze::bvh {

/// Calls `leaf_fn(const Node&)` for the leaves that `is_apart(std::uint32_t node)` does not prune,
/// nor any node above them, until it returns Walk::Stop. Returns whether it did.
template <typename Apart, typename LeafFn>
Walk traverse_volume(const Tree& tree, Apart&& is_apart, LeafFn&& leaf_fn) {
  TraversalStack<std::uint32_t, 128> open;
  open.push(0);
  while (!open.empty()) {
    const std::uint32_t index = open.pop();
    if (is_apart(index)) continue;
    const Node& node = tree.nodes[index];
    if (node.is_leaf()) {
      if (leaf_fn(node) == Walk::Stop) return Walk::Stop;
      continue;
    }
    open.push(node.first + 1);
    open.push(node.first);
  }
  return Walk::Continue;
}

}  // namespace graze::bvh

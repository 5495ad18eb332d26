#pragma once

#include <graze/bvh/traversal.h>
#include <graze/bvh/tree.h>
#include <cstdint>

namespace graze::bvh {

/// Calls `leaf_fn(const Node&)` for the leaves that `are_apart(const Node&)` does not prune, nor
/// any node above them, until it returns Walk::Stop. Returns whether it did.
template <typename Apart, typename LeafFn>
Walk traverse_volume(const Tree& tree, Apart&& are_apart, LeafFn&& leaf_fn) {
  TraversalStack<std::uint32_t, 128> open;
  open.push(0);
  while (!open.empty()) {
    const Node& node = tree.nodes[open.pop()];
    if (are_apart(node)) continue;
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

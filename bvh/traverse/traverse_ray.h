#pragma once

#include <graze/bvh/traverse/traversal.h>
#include <graze/bvh/tree/tree.h>
#include <graze/bvh/value/ray_slabs.h>

#include <cstdint>
#include <utility>

namespace graze::bvh {

/// Calls `leaf_fn(const Node&)` for the leaves that a ray may meet before `limit`, roughly from
/// near to far. `entry_fn(const Node&)` is entry() of the node's box with that limit, which leaf_fn
/// may lower.
template <typename EntryFn, typename LeafFn>
void traverse_ray(const Tree& tree, const double& limit, EntryFn&& entry_fn, LeafFn&& leaf_fn) {
  struct Open {
    std::uint32_t node;
    double entry;
  };
  TraversalStack<Open, 128> open;
  const double at_root = entry_fn(tree.root());
  if (at_root != kNever) open.push({0, at_root});
  while (!open.empty()) {
    const Open top = open.pop();
    if (top.entry > limit) continue;  // it has come down since the node was put aside
    const Node& node = tree.nodes[top.node];
    if (node.is_leaf()) {
      leaf_fn(node);
      continue;
    }
    Open near{node.first, entry_fn(tree.nodes[node.first])};
    Open far{node.first + 1, entry_fn(tree.nodes[node.first + 1])};
    if (far.entry < near.entry) std::swap(near, far);
    if (far.entry != kNever) open.push(far);
    if (near.entry != kNever) open.push(near);
  }
}

}  // namespace graze::bvh

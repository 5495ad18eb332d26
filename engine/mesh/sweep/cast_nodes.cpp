#include <graze/engine/mesh/sweep/cast_nodes.h>

namespace graze::contacts {

const CastNodes::Span& CastNodes::span_of(std::uint32_t node) {
  const std::uint32_t at = node % kNodes;
  if (node_at_[at] == node) return span_[at];
  node_at_[at] = node;
  const bvh::Node& of_tree = tree_.nodes[node];
  if (!of_tree.is_leaf()) {
    span_[at] = directions_.of_box(side_, of_tree.box);
    return span_[at];
  }
  const Leaf& of_leaf = leaf(node);
  span_[at] = of_leaf.span[0];
  for (std::uint32_t i = 1; i < of_tree.count; ++i)
    span_[at] = CastDirections::around(span_[at], of_leaf.span[i]);
  return span_[at];
}

const CastNodes::Leaf& CastNodes::leaf(std::uint32_t node) {
  const std::uint32_t at = node % kLeaves;
  if (leaf_at_[at] == node) return leaf_[at];
  leaf_at_[at] = node;
  const bvh::Node& of_tree = tree_.nodes[node];
  for (std::uint32_t i = 0; i < of_tree.count; ++i) {
    leaf_[at].triangle[i] = mesh_.triangle(tree_.primitives[of_tree.first + i]);
    leaf_[at].span[i] = directions_.of_triangle(side_, leaf_[at].triangle[i]);
  }
  return leaf_[at];
}

}  // namespace graze::contacts

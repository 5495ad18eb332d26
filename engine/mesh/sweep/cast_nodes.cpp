#include <graze/engine/mesh/sweep/cast_nodes.h>

namespace graze::contacts {

const CastNodes::Span& CastNodes::measured(std::uint32_t node) {
  const std::uint32_t at = node % kNodes;
  const Pairs pairs = kept_[at].node == node ? Pairs::WithNormal : Pairs::All;
  kept_[at] = {node, normal_};
  Span& span = span_[at];
  const bvh::Node& of_tree = tree_.nodes[node];
  if (!of_tree.is_leaf()) {
    directions_.measure_kdop(kdops_[node], pairs, span);
    return span;
  }
  const Leaf& of_leaf = leaf(node);
  span = of_leaf.span[0];
  for (std::uint32_t i = 1; i < of_tree.count; ++i)
    span = CastDirections::around(span, of_leaf.span[i]);
  return span;
}

const CastNodes::Leaf& CastNodes::leaf(std::uint32_t node) {
  const std::uint32_t at = node % kLeaves;
  const bool is_kept = leaf_at_[at] == node;
  if (is_kept && leaf_normal_[at] == normal_) return leaf_[at];
  const CastDirections::Pairs pairs = is_kept ? Pairs::WithNormal : Pairs::All;
  leaf_at_[at] = node;
  leaf_normal_[at] = normal_;
  const bvh::Node& of_tree = tree_.nodes[node];
  Leaf& leaf = leaf_[at];
  for (std::uint32_t i = 0; i < of_tree.count; ++i) {
    if (!is_kept) leaf.triangle[i] = mesh_.triangle(tree_.primitives[of_tree.first + i]);
    directions_.measure_triangle(CastDirections::Side::A, leaf.triangle[i], pairs, leaf.span[i]);
  }
  return leaf;
}

}  // namespace graze::contacts

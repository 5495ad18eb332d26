#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/refit/refit.h>
#include <graze/bvh/refit/refit_references.h>
#include <graze/bvh/tree/node_lanes.h>
#include <graze/bvh/value/boxes.h>
#include <graze/bvh/value/parallel.h>

#include <string>

namespace graze::bvh {
namespace {

/// The number of nodes whose leaves one task fits.
constexpr std::size_t kGrain = 2048;

void fit_leaf(Node& leaf, std::span<const Reference> references) {
  Bounds bounds = empty_bounds();
  for (const Reference& reference : references.subspan(leaf.first, leaf.count))
    bounds = merged(bounds, reference.box);
  leaf = node_over(bounds, leaf.first, leaf.count);
}

}  // namespace

void refit(Tree& tree, std::span<const Reference> references, const LocalFrame& frame) {
  tree.frame = frame;
  for_in_parallel(tbb::blocked_range<std::size_t>(0, tree.nodes.size(), kGrain),
                  [&](const tbb::blocked_range<std::size_t>& range) {
                    in_standard_arithmetic([&] {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) {
                        if (tree.nodes[i].is_leaf()) fit_leaf(tree.nodes[i], references);
                      }
                    });
                  });
  // Children stand behind their parents.
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    Node& node = tree.nodes[i];
    if (!node.is_leaf())
      node = node_around(tree.nodes[node.first], tree.nodes[node.first + 1], node.first);
  }
}

FittedReferences fitted_references(const Tree& tree, std::span<const Aabb> boxes) {
  const Aabb bounds = checked_bounds(boxes);
  if (boxes.size() != tree.primitives.size()) {
    throw InputError("refit: " + std::to_string(boxes.size()) + " boxes for a tree of " +
                     std::to_string(tree.primitives.size()));
  }
  const LocalFrame frame = LocalFrame::around(bounds);
  return {frame, references_to(boxes, frame, tree.primitives)};
}

void refit(Tree& tree, std::span<const Aabb> boxes) {
  FittedReferences fitted = fitted_references(tree, boxes);
  refit(tree, fitted.references.all(), fitted.frame);
}

}  // namespace graze::bvh

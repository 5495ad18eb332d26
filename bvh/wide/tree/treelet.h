#pragma once

#include <graze/bvh/value/float_box.h>
#include <graze/bvh/wide/tree/wide_node.h>

#include <cstdint>
#include <vector>

namespace graze::bvh {

/// Which primitives, by their places in a wide tree's order, are those of a treelet, and where they
/// lie.
struct TreeletPart {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  int depth = 0;  ///< binary nodes above
  FloatBox box;
};

/// Nodes, the primitives that their leaves count from, and these primitives' corners: in the tree's
/// frame less an origin of the treelet's own, so that floats tell points apart that are close for
/// the treelet, however large the tree.
struct Treelet {
  std::vector<WideNode> nodes;
  std::vector<float> corners;  ///< of a leaf: 9 rows, one behind the other, from 9 * its first on
  double origin[3] = {0, 0, 0};
  float largest_coordinate = 0;  ///< no coordinate of a corner is larger, nor its negative
  std::uint32_t first = 0;

  // cost_of() the nodes when they were built, and when their axes were last chosen.
  float built_cost = 0;
  float fitted_cost = 0;
};

/// How treelets came to be.
struct TreeletCounts {
  std::uint64_t built = 0;     ///< from primitives alone
  std::uint64_t refitted = 0;  ///< from the nodes of an earlier tree
};

}  // namespace graze::bvh

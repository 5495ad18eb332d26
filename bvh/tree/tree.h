#pragma once

#include <graze/bvh/value/float_box.h>
#include <graze/bvh/value/local_frame.h>
#include <cstdint>
#include <vector>

namespace graze::bvh {

/// A leaf holds `count` primitives from `first` on in the tree's order; an inner node has count 0
/// and its children at `first` and `first + 1`, behind itself.
struct Node {
  FloatBox box;
  std::uint32_t first;
  std::uint32_t count;

  bool is_leaf() const { return count != 0; }
};
static_assert(sizeof(Node) == 32, "two nodes, the children of one, fill a cache line");

/// A hierarchy over primitives that are known by index alone. It is the one topology of the house:
/// data that build() makes, refit() changes and the traverse_* loops walk.
struct Tree {
  LocalFrame frame;
  std::vector<Node> nodes;                ///< nodes[0] is the root; never empty
  std::vector<std::uint32_t> primitives;  ///< the primitives' indices in the order of the leaves

  const Node& root() const { return nodes[0]; }
};

}  // namespace graze::bvh

#pragma once

#include <graze/bvh/tree/tree.h>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// A subtree that takes the place of a node of another tree. Its nodes count nodes and primitives
/// from its own first ones.
struct Graft {
  std::size_t at;  ///< the index of the node
  std::uint32_t first_primitive;
  std::vector<Node> nodes;
};

/// A tree's nodes, and for those that were kept which nodes of the stock they were.
struct GraftedNodes {
  struct Kept {
    std::uint32_t at;
    std::uint32_t of_stock;
  };
  std::vector<Node> nodes;
  std::vector<Kept> kept;
};

/// Returns the nodes of the stock with the grafts, each of which is freed once copied, in place of
/// what they replace: depth first, the children of a node side by side behind it, as if all had
/// been built at once. Grafts must not lie below each other. It takes linear time.
GraftedNodes grafted(std::span<const Node> stock, std::vector<Graft> grafts);

}  // namespace graze::bvh

#pragma once

#include <graze/bvh/tree/tree.h>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// subtree_costs() of degradation.h, of nodes that need not be all of a tree.
std::vector<float> subtree_costs(std::span<const Node> nodes, float primitive_cost);

/// What each node cost when it was built, costs now, and by how much it may have grown.
struct Growth {
  std::span<const float> then;
  std::span<const float> now;
  float tolerated;

  bool is_degraded(std::size_t node) const { return now[node] > tolerated * then[node]; }
};

/// A node to be built anew.
struct DegradedNode {
  std::uint32_t node;
  int depth;
};

/// The uppermost of the degraded nodes that are to blame for it.
std::vector<DegradedNode> find_degraded(std::span<const Node> nodes, const Growth& growth);

}  // namespace graze::bvh

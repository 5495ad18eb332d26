#pragma once

#include <graze/bvh/tree/tree.h>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// Answers subtree_costs() of degradation.h for nodes that need not be all of a tree.
std::vector<float> subtree_costs(std::span<const Node> nodes, float primitive_cost);

/// The costs of each node when it was built and now, and by how much they may have grown.
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

/// Returns the uppermost of the degraded nodes that are to blame for it.
std::vector<DegradedNode> find_degraded(std::span<const Node> nodes, const Growth& growth);

}  // namespace graze::bvh

#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/tree/tree.h>
#include <cstdint>
#include <span>

namespace graze::bvh {

struct BuildSettings {
  /// Leaves hold at most this many primitives. More make smaller trees and more primitive tests.
  std::uint32_t max_leaf_size = 4;
  /// The cost of testing a primitive, in tests of a node. Dearer primitives make smaller leaves.
  float primitive_cost = 1.5f;
  /// The cost of a place that a leaf leaves empty, in primitives, where more than four are divided:
  /// from 0 for nothing to 1, where a leaf costs the same however full it is. Dearer places make
  /// fewer and fuller leaves.
  float empty_place_cost = 0;
};

/// Builds a tree over the boxes of at least one and at most 2^31 - 1 primitives, by the surface
/// area heuristic on 16 bins of centroids (Wald, "On fast construction of SAH-based bounding volume
/// hierarchies", 2007), on all orders of centroids where there are at most eight, and on all trees
/// where there are at most four. It takes O(n log n); the depth is at most 64 + log2 n even where
/// centroids coincide or crowd exponentially. It needs less than 60 bytes a primitive beside its
/// result. It is parallel by oneTBB; the tree is the same for any number of threads. Throws
/// InputError for no boxes, one that is not valid, or an empty_place_cost that is not from 0 to 1.
Tree build(std::span<const Aabb> boxes, const BuildSettings& settings = {});

}  // namespace graze::bvh

#pragma once

#include <graze/bvh/tree/tree.h>
#include <cstddef>

namespace graze::bvh {

struct TreeStatistics {
  std::size_t node_count = 0;
  std::size_t leaf_count = 0;
  std::size_t depth = 0;            ///< inner nodes on the longest path from the root to a leaf
  std::size_t largest_leaf = 0;     ///< primitives
  double mean_leaf_size = 0;        ///< primitives
  double expected_node_visits = 0;  ///< those of a random line through the root: surface area
                                    ///< heuristic
  double expected_primitive_tests = 0;
  std::size_t bytes = 0;  ///< bytes of nodes and primitive indices
};

/// Returns statistics of a tree, in linear time.
TreeStatistics statistics_of(const Tree& tree);

}  // namespace graze::bvh

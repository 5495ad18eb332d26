#pragma once

#include <graze/bvh/build/build.h>
#include <graze/bvh/tree/tree.h>
#include <cstddef>
#include <span>
#include <vector>

namespace graze::bvh {

/// Returns for each node of the tree what a random line that meets its box has to expect from the
/// node down, in tests of a node, by the surface area heuristic. Compared with what it was when the
/// node was built, it says how far refits have spoiled the subtree. It takes linear time.
std::vector<float> subtree_costs(const Tree& tree, float primitive_cost);

struct RebuildSettings {
  /// The settings that the tree was built with.
  BuildSettings build;
  /// A subtree is built anew where it costs more than this many times what it did.
  float tolerated_degradation = 1.5f;
};

/// Does what refit() does, and then builds anew what has degraded, where it has: of the subtrees
/// that cost more than is tolerated, those whose own boxes have grown into each other, rather than
/// all that hold them. The rest of the tree stays. `costs` are subtree_costs() of the tree when it
/// was built; they come back as those of the new tree when each of its nodes was built. Returns how
/// many primitives lie below what was built. It takes linear time, and O(m log m) for those m. It
/// is parallel; the result is the same for any number of threads.
///
/// Throws InputError, and leaves the tree as it was, as refit() does, for another number of costs
/// than of nodes, and for a tree in which the primitives below a node do not lie side by side, as
/// build() lays them.
std::size_t refit_and_rebuild(Tree& tree, std::vector<float>& costs, std::span<const Aabb> boxes,
                              const RebuildSettings& settings = {});

}  // namespace graze::bvh

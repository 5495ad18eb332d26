#pragma once

// This decides which nodes of a binary tree become the children of one wide node. It is private.

#include <graze/bvh/tree/tree.h>

#include <array>
#include <cstdint>
#include <vector>

namespace graze::bvh {

/// The cheapest way to collapse a binary tree by the surface area heuristic, subtrees of up to
/// `leaf_size` primitives being leaves (Ylitie, Karras, Laine, 2017).
class RayGroups {
 public:
  static constexpr std::uint32_t kWidth = 8;

  RayGroups(const Tree& tree, std::uint32_t leaf_size);

  bool is_leaf(std::uint32_t binary) const { return below_[binary].count <= leaf_size_; }

  /// Return the places of all that is below a node of the binary tree.
  std::uint32_t first(std::uint32_t binary) const { return below_[binary].first; }
  std::uint32_t count(std::uint32_t binary) const { return below_[binary].count; }

  /// Fills in the children of the wide node that the binary one becomes. Returns how many there
  /// are.
  std::uint32_t children(std::uint32_t binary, std::uint32_t (&found)[kWidth]) const;

 private:
  struct Places {
    std::uint32_t first;
    std::uint32_t count;
  };
  struct Cut {
    float cost;
    std::uint32_t for_first;
  };

  Cut best_cut(std::uint32_t binary, std::uint32_t parts) const;
  void collect(std::uint32_t binary, std::uint32_t parts, std::uint32_t (&found)[kWidth],
               std::uint32_t& count) const;

  const Tree& tree_;
  std::uint32_t leaf_size_;
  std::vector<Places> below_;
  std::vector<std::array<float, kWidth>> costs_;  ///< costs as at most 1, 2, ... children of
                                                  ///< another node
};

}  // namespace graze::bvh

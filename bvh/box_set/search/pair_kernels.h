#pragma once

// These loops over blocks of boxes are compiled once for each SIMD target. What they find, and in
// which order, is the same on all of them.

#include <graze/bvh/box_set/search/pair_lists.h>
#include <graze/bvh/box_set/store/block.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// Two blocks whose boxes may overlap, each on a level of its own tree.
struct BlockPair {
  std::uint32_t a;
  std::uint32_t b;
  std::uint8_t level_a;
  std::uint8_t level_b;
  std::uint16_t trees;  ///< the two trees, for whoever keeps a list of such pairs
};

/// Appends the pairs of boxes below each of `starts` that overlap, exactly, and returns how many
/// pairs of blocks of boxes it looked at. The trees are one and the same, or share no box; a tree
/// is paired with itself from equal blocks, each pair of boxes being found once. The order of what
/// it appends does not depend on how the starts are shared among calls.
std::uint64_t find_pairs(const TreeView& a, const TreeView& b, std::span<const BlockPair> starts,
                         PairBuffer& out);

/// Appends the pairs of blocks that `start` leads to, one step down. `start` must not be two blocks
/// of boxes.
void split_pair(const TreeView& a, const TreeView& b, BlockPair start, std::vector<BlockPair>& out);

/// Appends the proxies of the boxes that overlap `box`, exactly.
void find_overlapping(const TreeView& tree, const OrderedBox& box, std::vector<std::uint32_t>& out);

/// A box that overlaps a mover where it was, where it is, or both.
struct MoverOverlap {
  std::uint32_t proxy;
  std::uint8_t mover;       ///< its number among those that were looked up together
  std::uint8_t overlapped;  ///< 1 if it overlaps the mover where that was
  std::uint8_t overlaps;    ///< 1 if it overlaps the mover where that is
};

/// A block that a mover may overlap.
struct Reached {
  std::uint32_t mover;
  std::uint32_t block;
};

/// The working memory of a lookup of movers.
struct Lookup {
  std::vector<Reached> reached;  ///< blocks on the level that is looked at
  std::vector<Reached> below;    ///< blocks one level down
};

/// Appends what overlaps before[i] or after[i], exactly, for up to 16 movers: they go down level by
/// level, so that none waits for what it will read. no_box() overlaps nothing.
void find_overlapping_either(const TreeView& tree, std::span<const OrderedBox> before,
                             std::span<const OrderedBox> after, Lookup& lookup,
                             std::vector<MoverOverlap>& out);

}  // namespace graze::bvh

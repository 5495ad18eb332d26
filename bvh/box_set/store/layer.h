#pragma once

#include <graze/bvh/box_set/store/block.h>

#include <cstdint>
#include <vector>

namespace graze::bvh {

/// Writes the bounds of blocks [first, last) of one level into their lanes of the level above. The
/// result is the same on every SIMD target (refit_kernels.cpp).
void refit_blocks(const Block* below, std::uint32_t first, std::uint32_t last, Block* above);

/// A run of blocks of boxes and the implicit tree over them. The blocks belong to the box set; the
/// levels above are here.
struct Layer {
  std::uint32_t first_block = 0;
  std::uint32_t block_count = 0;
  int top = 0;
  std::vector<Block> upper[kMaxLevels];  ///< the levels above the boxes; [0] stays empty
  std::vector<float> sorted_perimeter;   ///< the perimeter() of each block when it was sorted
  std::vector<std::uint16_t> holed;      ///< for each block of upper[1], which blocks below have
                                         ///< holes
  std::vector<bool> is_filled;           ///< likewise, whether a box came to a hole since the last
                                         ///< refit

  bool needs_refit_of_all = false;

  /// Makes the levels fit `count` blocks from `first` on; new lanes are empty.
  void reshape(std::uint32_t first, std::uint32_t count);

  /// Makes room for so many blocks: reshape() to no more of them throws nothing.
  void reserve(std::uint32_t count);

  /// Returns the tree over the blocks, with what belongs to them; all three begin with the first
  /// block.
  TreeView view(const Block* boxes, const LowBlock* low, const std::uint32_t* proxy) const;

  /// Note that a box has gone from a block that was sorted, or that a hole of it was filled. The
  /// empty lanes at the end of the layer are no holes.
  void note_hole(std::uint32_t block);
  void note_filled(std::uint32_t block) {
    holed[block >> kLaneBits] &= static_cast<std::uint16_t>(~(1u << (block & (kLanes - 1))));
  }

  /// Returns perimeter() of all boxes of a block, as of the last refit.
  double perimeter_of(std::uint32_t block) const;

  /// Computes the bounds of all blocks on all levels.
  void refit_all(const Block* boxes);

  /// Do the same in parts: the first empties the levels above the boxes, the second computes the
  /// bounds of all blocks from a level up.
  void clear_above_boxes();
  void refit_above(int level, const Block* boxes);

  /// Computes the bounds of the blocks in `dirty`, numbers within the layer, and of what lies above
  /// them. It uses up the list.
  void refit_paths(const Block* boxes, std::vector<std::uint32_t>& dirty);
};

/// Returns the perimeter of one lane's box, as b2DynamicTree has it, divided by 32, in metres and
/// rounded: an eighth of the sum of the three edges. It is always finite, so that ratios are
/// numbers, and 0 for an empty lane. It is a measure of quality: no answer depends on it.
double perimeter(const Block& block, std::uint32_t lane);

/// Returns the degradation of a block since it was sorted, from its perimeters now and then:
/// roughly by how many times the blocks that it meets have become more, less one. It is at most
/// `limit`.
double degradation(double now, double sorted, double limit);

}  // namespace graze::bvh

#pragma once

// What the kernels of the box set share: plain data.

#include <graze/bvh/box_set/store/ordered_box.h>

#include <cstdint>
#include <limits>

namespace graze::bvh {

inline constexpr std::uint32_t kLanes = 16;            // boxes in a block: one register of AVX-512
inline constexpr std::uint32_t kLaneBits = 4;          // log2(kLanes)
inline constexpr int kMaxLevels = 9;                   // of a tree over less than 2^28 boxes
inline constexpr std::uint32_t kNobody = 0xffffffffu;  // the proxy of an empty lane

/// High halves of 16 boxes, row by row: min x, y, z, max x, y, z. A level above the boxes is made
/// of the same blocks: a lane there holds all boxes of one block below.
struct alignas(64) Block {
  std::int32_t row[6][kLanes];
};

/// The low halves that go with a block of boxes. They are read only where high halves are equal.
struct alignas(64) LowBlock {
  std::uint32_t row[6][kLanes];
};

static_assert(sizeof(Block) == 384 && sizeof(LowBlock) == 384);

/// High halves that overlap nothing: no finite number has these keys.
inline constexpr std::int32_t kEmptyMin = std::numeric_limits<std::int32_t>::max();
inline constexpr std::int32_t kEmptyMax = std::numeric_limits<std::int32_t>::min();

static inline void clear_lane(Block& block, std::uint32_t lane) {
  for (int c = 0; c < 3; ++c) {
    block.row[c][lane] = kEmptyMin;
    block.row[c + 3][lane] = kEmptyMax;
  }
}

static inline Block empty_block() {
  Block block;
  for (std::uint32_t lane = 0; lane < kLanes; ++lane)
    clear_lane(block, lane);
  return block;
}

static inline void set_lane(Block& high, LowBlock& low, std::size_t lane, const OrderedBox& box) {
  for (std::size_t c = 0; c < 6; ++c) {
    high.row[c][lane] = high_half(box[c]);
    low.row[c][lane] = low_half(box[c]);
  }
}

static inline OrderedBox lane_box(const Block& high, const LowBlock& low, std::uint32_t lane) {
  OrderedBox box;
  for (std::size_t c = 0; c < 6; ++c)
    box[c] = joined(high.row[c][lane], low.row[c][lane]);
  return box;
}

/// One implicit 16-ary tree: lane i of block j on level l + 1 holds block 16 j + i of level l.
/// The block on the top level has one lane, the bounds of all.
struct TreeView {
  const Block* level[kMaxLevels];
  const LowBlock* low;         ///< of level 0
  const std::uint32_t* proxy;  ///< of each lane of level 0; kNobody where it is empty
  int top;
};

}  // namespace graze::bvh

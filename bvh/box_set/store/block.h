#pragma once

// Boxes are kept as plain data that the kernels read. Doubles become integers of the same order, in
// two halves: comparing the high halves of two numbers decides all but the pairs whose high halves
// are equal, without any rounding. Sixteen boxes share a block.

#include <graze/bvh/aabb.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace graze::bvh {

// These are static so that each source compiles its own: an inline function is shared by the
// linker, and the copy that it keeps could be one compiled with a user's -ffast-math.

/// Returns an integer for each finite double: a < b exactly if ordered_key(a) < ordered_key(b).
/// Both zeros have the key 0. Only integers are used, so that no compiler flag can fold the zeros
/// back apart.
static inline std::int64_t ordered_key(double value) {
  const std::int64_t bits = std::bit_cast<std::int64_t>(value);
  const std::int64_t sign = bits >> 63;
  // The magnitude of a negative number counts downwards: -(magnitude), which sends -0 to 0.
  return ((bits & INT64_MAX) ^ sign) - sign;
}

/// Returns the double whose key this is.
static inline double value_of_key(std::int64_t key) {
  const std::int64_t sign = key >> 63;
  return std::bit_cast<double>(((key ^ sign) - sign) | (sign & INT64_MIN));
}

static inline std::int32_t high_half(std::int64_t key) {
  return static_cast<std::int32_t>(key >> 32);
}

static inline std::uint32_t low_half(std::int64_t key) {
  return static_cast<std::uint32_t>(key);
}

static inline std::int64_t joined(std::int32_t high, std::uint32_t low) {
  return static_cast<std::int64_t>(
      static_cast<std::uint64_t>(static_cast<std::uint32_t>(high)) << 32 | low);
}

/// A box as the keys of min x, y, z, max x, y, z.
using OrderedBox = std::array<std::int64_t, 6>;

static inline OrderedBox ordered_box(const Aabb& box) {
  OrderedBox keys;
  for (std::size_t c = 0; c < 3; ++c) {
    keys[c] = ordered_key(box.min.data()[c]);
    keys[c + 3] = ordered_key(box.max.data()[c]);
  }
  return keys;
}

static inline Aabb box_of_keys(const OrderedBox& keys) {
  Aabb box;
  for (std::size_t c = 0; c < 3; ++c) {
    box.min.data()[c] = value_of_key(keys[c]);
    box.max.data()[c] = value_of_key(keys[c + 3]);
  }
  return box;
}

/// Returns a box that overlaps nothing.
static inline OrderedBox no_box() {
  return {INT64_MAX, INT64_MAX, INT64_MAX, INT64_MIN, INT64_MIN, INT64_MIN};
}

/// True exactly when the closed boxes share a point.
static inline bool overlap(const OrderedBox& a, const OrderedBox& b) {
  bool is_overlapping = true;
  for (std::size_t c = 0; c < 3; ++c)
    is_overlapping &= a[c] <= b[c + 3] && b[c] <= a[c + 3];
  return is_overlapping;
}

inline constexpr std::uint32_t kLanes = 16;    // the number of boxes in a block: one register of
                                               // AVX-512
inline constexpr std::uint32_t kLaneBits = 4;  // log2(kLanes)
inline constexpr int kMaxLevels = 9;           // the levels of a tree over less than 2^28 boxes
inline constexpr std::uint32_t kNullIndex = 0xffffffffu;  // the index that stands for no proxy and
                                                          // for no place

/// The high halves of 16 boxes, row by row: min x, y, z, max x, y, z. A level above the boxes is
/// made of the same blocks: a lane there holds all boxes of one block below.
struct alignas(64) Block {
  std::int32_t row[6][kLanes];
};

/// The low halves that go with a block of boxes. A search reads them only where high halves are
/// equal.
struct alignas(64) LowBlock {
  std::uint32_t row[6][kLanes];
};

static_assert(sizeof(Block) == 384 && sizeof(LowBlock) == 384);

/// The high halves of a box that overlaps nothing: no finite number has these keys.
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
  const LowBlock* low;         ///< low halves of level 0
  const std::uint32_t* proxy;  ///< the proxy in each lane of level 0; kNullIndex where it is empty
  int top;
};

}  // namespace graze::bvh

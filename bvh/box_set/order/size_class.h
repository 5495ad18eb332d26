#pragma once

#include <graze/bvh/box_set/store/block.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace graze::bvh {

inline constexpr int kClasses = 1024, kClassShift = 512;  // of sizes, and which of them is 0
inline constexpr std::uint8_t kNoLayer = 0xff;            // of a class of which there was no box

/// The class of a box by its longest side, in steps of 4; points and what is nearly one are in the
/// lowest class.
static inline int size_class(const OrderedBox& box) {
  double longest = 0;
  for (std::size_t c = 0; c < 3; ++c)
    longest = std::max(longest, 0.5 * value_of_key(box[c + 3]) - 0.5 * value_of_key(box[c]));
  return (longest > 0x1p-1000 ? std::ilogb(longest) >> 1 : -501) + kClassShift;
}

}  // namespace graze::bvh

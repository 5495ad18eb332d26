#pragma once

#include <graze/bvh/box_set/order/kd_order.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

inline constexpr int kClasses = 1024, kClassShift = 512;  // how many size classes there are, and
                                                          // which is that of exponent 0
inline constexpr std::uint8_t kNoLayer = 0xff;            // the layer of a class that has no box

/// Returns the class of a box by its longest side, in steps of 4; points and what is nearly one are
/// in the lowest class.
static inline int size_class(const OrderedBox& box) {
  double longest = 0;
  for (std::size_t c = 0; c < 3; ++c)
    longest = std::max(longest, 0.5 * value_of_key(box[c + 3]) - 0.5 * value_of_key(box[c]));
  return (longest > 0x1p-1000 ? std::ilogb(longest) >> 1 : -501) + kClassShift;
}

/// Boxes of about one size.
struct SizeClass {
  double side;  ///< metres, the side of a typical box
  std::size_t count;
};

/// Decides which neighbouring classes had better lie in one tree. Boxes of another size stretch a
/// block; more trees mean more pairs of trees, whose blocks meet even where no boxes are near. What
/// weighs more depends on how densely boxes lie, of which the sample tells; it is reordered.
///
/// Returns for each class, in the order given, the number of its group, from 0 on. It is a guess at
/// costs: no answer depends on it.
std::vector<std::size_t> share_layers(std::span<const SizeClass> classes, std::span<KdItem> sample);

}  // namespace graze::bvh

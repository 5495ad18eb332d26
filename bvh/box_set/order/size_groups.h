#pragma once

#include <graze/bvh/box_set/order/kd_order.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// Boxes of about one size.
struct SizeClass {
  double side;  ///< metres, of a typical box
  std::size_t count;
};

/// Which neighbouring classes had better lie in one tree. Boxes of another size stretch a block;
/// more trees mean more pairs of trees, whose blocks meet even where no boxes are near. What weighs
/// more depends on how densely boxes lie, of which the sample tells; it is reordered.
///
/// Returns for each class, in the order given, the number of its group, from 0 on. A guess at
/// costs: no answer depends on it.
std::vector<std::size_t> group_sizes(std::span<const SizeClass> classes, std::span<KdItem> sample);

}  // namespace graze::bvh

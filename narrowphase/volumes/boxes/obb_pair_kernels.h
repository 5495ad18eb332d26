#pragma once

// Checks two oriented boxes and tells them apart at once, in lanes. The answer is what
// bvh::check_box() and may_overlap() answer, bit for bit.

#include <graze/bvh/obb.h>

namespace graze::narrowphase {

enum class ObbPairAnswer {
  Apart,
  MayOverlap,
  Open,  ///< ask check_box() and may_overlap(): a box is not valid, or the two are as large
};

ObbPairAnswer look_at_pair(const Obb& box_a, const Obb& box_b);

}  // namespace graze::narrowphase

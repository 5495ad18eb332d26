#pragma once

// One question about two oriented boxes in lanes: both are checked and told apart at once. What it
// answers is what bvh::check_box() and may_overlap() answer, bit for bit.

#include <graze/bvh/obb.h>

namespace graze::narrowphase {

enum class ObbPairAnswer {
  Apart,
  MayOverlap,
  Open,  ///< ask check_box() and may_overlap(): a box is not valid, or the two are as large
};

ObbPairAnswer look_at_pair(const Obb& box_a, const Obb& box_b);

}  // namespace graze::narrowphase

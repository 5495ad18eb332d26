#pragma once

// Boxes with room around them. Private to engine/world.

#include <graze/bvh/aabb.h>

namespace graze {

/// The box with room around it, outward, for all that may be that far away or nearer, metres.
Aabb grown(const Aabb& box, double width);

/// The longest side, at most kLargestLength.
double width_of(const Aabb& box);

/// intersects() of two boxes that are valid: nothing is checked.
bool share_a_point(const Aabb& s, const Aabb& t);

}  // namespace graze

#pragma once

// Grows boxes, and measures them. Private to engine/world.

#include <graze/bvh/aabb.h>

namespace graze {

/// Returns the box with room around it, rounded outward, for all that may be that far away or
/// nearer, metres.
Aabb grown(const Aabb& box, double width);

/// Returns the longest side, metres, at most kLargestLength.
double width_of(const Aabb& box);

/// Returns intersects() of two boxes, which must be valid: nothing is checked.
bool share_a_point(const Aabb& s, const Aabb& t);

}  // namespace graze

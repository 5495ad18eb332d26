#pragma once

#include <graze/bvh/aabb.h>

namespace graze {

/// True if and only if the closed boxes share a point: exact, a comparison of their doubles. Throws
/// InputError for a box that is not finite or has min > max.
bool intersects(const Aabb& box_a, const Aabb& box_b);

}  // namespace graze

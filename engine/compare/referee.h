#pragma once

#include <graze/bvh/aabb.h>
#include <graze/narrowphase/triangle.h>

namespace graze::compare {

/// True if and only if the two closed triangles share a point: the arbiter of law 2. It asks
/// whether a convex combination of one triangle's vertices equals one of the other's, as a linear
/// program in integers of any size. It shares no formula with the library, which takes signs of
/// determinants. It is exact for every finite double. Throws InputError for a coordinate that is
/// not finite. Takes some ten microseconds for coordinates of like size, up to milliseconds at the
/// ends of the range.
bool referee_intersects(const Triangle& triangle_a, const Triangle& triangle_b);

/// Decides the same for a triangle and a closed box: the arbiter of law 3. Throws InputError for
/// values that are not finite or a box with min > max.
bool referee_intersects(const Triangle& triangle, const Aabb& box);

}  // namespace graze::compare

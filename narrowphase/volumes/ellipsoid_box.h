#pragma once

#include <graze/bvh/aabb.h>
#include <graze/narrowphase/volumes/ellipsoid.h>

namespace graze {

/// True if and only if the closed ellipsoid and the closed box share a point, in real arithmetic,
/// on their doubles. Throws InputError for values that are not finite, a negative semi-axis, or a
/// box with min > max.
/// Arvo, "A simple method for box-sphere intersection testing", Graphics Gems, 1990.
bool intersects(const Ellipsoid& ellipsoid, const Aabb& box);
bool intersects(const Aabb& box, const Ellipsoid& ellipsoid);

}  // namespace graze

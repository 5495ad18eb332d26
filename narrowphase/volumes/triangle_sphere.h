#pragma once

#include <graze/bvh/sphere.h>
#include <graze/narrowphase/triangle.h>

namespace graze {

/// True if and only if the closed triangle and the closed ball share a point, in real arithmetic,
/// on their doubles. Touching counts; degenerate triangles and a radius of 0 are what they are.
/// Throws InputError for values that are not finite or a negative radius.
bool intersects(const Triangle& triangle, const Sphere& sphere);

}  // namespace graze

#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/kdop.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/sphere.h>

namespace graze {

// These return cubic metres and square metres, rounded: the relative error is a few 1e-16 for boxes
// and spheres, and for k-DOPs about 1e-13 of the volume and surface of their bounds. They are
// infinite where that overflows. The volumes must be valid; nothing is checked.

/// Returns the volume, cubic metres; 0 where it is flat.
double volume(const Aabb& box);
double volume(const Sphere& sphere);
double volume(const Obb& box);

/// Returns the volume of the points within all slabs, 0 if there are none: loose slabs change
/// nothing.
double volume(const KDop<18>& kdop);

/// Returns the area, square metres: that of both sides where a volume is flat.
double surface(const Aabb& box);
double surface(const Sphere& sphere);
double surface(const Obb& box);
double surface(const KDop<18>& kdop);

}  // namespace graze

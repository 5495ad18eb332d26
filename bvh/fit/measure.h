#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/kdop.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/sphere.h>

namespace graze {

// Cubic metres and square metres, rounded: the relative error is a few 1e-16 for boxes and spheres,
// and for k-DOPs about 1e-13 of the volume and surface of their bounds. Infinite where that
// overflows. The volumes must be valid; nothing is checked.

/// The volume, cubic metres; 0 where it is flat.
double volume(const Aabb& box);
double volume(const Sphere& sphere);
double volume(const Obb& box);

/// Of the points within all slabs, 0 if there are none: loose slabs cost and change nothing.
double volume(const KDop<18>& kdop);

/// The area of both sides where a volume is flat.
double surface(const Aabb& box);
double surface(const Sphere& sphere);
double surface(const Obb& box);
double surface(const KDop<18>& kdop);

}  // namespace graze

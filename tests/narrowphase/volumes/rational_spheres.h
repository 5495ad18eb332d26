#pragma once

// The same questions in rational arithmetic, by distances that are divided out where the library
// compares polynomials: the oracle of the tests in this folder. Slow, and only for finite input.

#include <graze/narrowphase/triangle.h>
#include <graze/narrowphase/volumes/ellipsoid.h>
#include <graze/narrowphase/volumes/hollow_volumes.h>

namespace graze::oracle {

bool overlap(const Sphere& a, const Sphere& b);
bool overlap(const Sphere& sphere, const Aabb& box);
bool overlap(const Sphere& sphere, const HollowAabb& box);
bool overlap(const HollowSphere& sphere, const Aabb& box);
bool overlap(const HollowSphere& sphere, const HollowAabb& box);
bool overlap(const Ellipsoid& ellipsoid, const Aabb& box);
bool overlap(const Triangle& triangle, const Sphere& sphere);

}  // namespace graze::oracle

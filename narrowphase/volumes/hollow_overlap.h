#pragma once

#include <graze/narrowphase/volumes/hollow_volumes.h>

namespace graze {

// These functions are the variants of Arvo's test ("A simple method for box-sphere intersection
// testing", Graphics Gems, 1990). Each is true if and only if the two sets share a point, in real
// arithmetic, on their doubles. All throw InputError as intersects(Sphere, Aabb) does.

/// Tests the solid ball against the surface of the box.
bool intersects(const Sphere& sphere, const HollowAabb& box);
bool intersects(const HollowAabb& box, const Sphere& sphere);

/// Tests the surface of the ball against the solid box.
bool intersects(const HollowSphere& sphere, const Aabb& box);
bool intersects(const Aabb& box, const HollowSphere& sphere);

/// Tests the surface of the ball against the surface of the box.
bool intersects(const HollowSphere& sphere, const HollowAabb& box);
bool intersects(const HollowAabb& box, const HollowSphere& sphere);

}  // namespace graze

#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/sphere.h>

namespace graze {

/// True if and only if the closed ball and the closed box share a point, in real arithmetic, on
/// their doubles. Throws InputError for values that are not finite, a negative radius, or a box
/// with min > max. For hollow volumes see hollow_overlap.h.
bool intersects(const Sphere& sphere, const Aabb& box);
bool intersects(const Aabb& box, const Sphere& sphere);

/// Tests the ball against an oriented box in the same way: the centre c goes into the box's frame
/// as law 3 says, q = c - t and then ((R_0i q_x + R_1i q_y) + R_2i q_z), each operation rounded to
/// double, and the ball about the result meets [-half_extents, half_extents] exactly. Throws
/// InputError or PoseError for an invalid volume, and InputError if the centre overflows on its way
/// into the frame.
bool intersects(const Sphere& sphere, const Obb& box);
bool intersects(const Obb& box, const Sphere& sphere);

}  // namespace graze

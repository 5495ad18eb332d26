#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/sphere.h>
#include <graze/narrowphase/verdict.h>

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

namespace narrowphase {

/// Returns what intersects() answers for valid volumes, with the stage that decided. Does not check
/// them.
Decision decide(const Sphere& sphere, const Aabb& box);

// These functions answer the same by three methods, which differ in speed and in how often rounded
// arithmetic suffices, never in the answer. All add up, axis by axis, the square of the distance
// from the centre to the box.

/// Decides by Arvo's method for closed volumes, "A simple method for box-sphere intersection
/// testing", Graphics Gems, 1990.
Decision decide_arvo(const Sphere& sphere, const Aabb& box);

/// Rejects as soon as the distance along one axis exceeds the radius: Larsson, Akenine-Möller,
/// Lengyel, "On faster sphere-box overlap testing", Journal of Graphics Tools 12(1), 2007.
Decision decide_quick_rejections(const Sphere& sphere, const Aabb& box);

/// Computes without branches: e = max(min - c, 0) + max(c - max, 0); from the same paper.
Decision decide_branch_free(const Sphere& sphere, const Aabb& box);

}  // namespace narrowphase
}  // namespace graze

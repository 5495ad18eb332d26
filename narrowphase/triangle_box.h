#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/obb.h>
#include <graze/narrowphase/triangle.h>

namespace graze {

/// True if and only if the closed triangle and the closed box share a point, in real arithmetic
/// (law 3). Touching counts; flat boxes and degenerate triangles are what they are.
/// Throws InputError for values that are not finite or a box with min > max.
/// Akenine-Möller, "Fast 3D triangle-box overlap testing", Journal of Graphics Tools 6(1), 2001.
bool intersects(const Triangle& triangle, const Aabb& box);

/// Tests the triangle against an oriented box in the same way: each vertex v goes into the box's
/// frame as law 3 says, q = v - t and then ((R_0i q_x + R_1i q_y) + R_2i q_z), each operation
/// rounded to double, and the triangle of the results meets [-half_extents, half_extents] exactly.
/// Throws InputError or PoseError for an invalid box, and InputError if a vertex overflows on its
/// way into the frame.
bool intersects(const Triangle& triangle, const Obb& box);

}  // namespace graze

#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/obb.h>

namespace graze {

/// False only if the closed boxes share no point, whichever way a box {pose {R, t}, h} is read: as
/// the points t + R y with |y_i| <= h_i, as those with |R^T (p - t)|_i <= h_i, or as the doubles p
/// that contains() finds inside by law 3's rounding. For poses that are not quite rotations these
/// are not quite the same points.
///
/// True is not sure. Boxes of true rotations that come out as overlapping although an axis of one
/// separates them are within 3e-14 of the sum of their half extents, along that axis; two edges at
/// an angle of theta, within 3e-14 / sin(theta) of it. A deviation of d from rotations adds about
/// 20 d. Boxes whose half extents add up to more than 2^1000 always come out as overlapping.
/// Swapping the boxes changes nothing. Throws InputError or PoseError for an invalid box.
/// Gottschalk, Lin, Manocha, "OBBTree", 1996; "Real-Time Rendering", 3rd ed., 16.13.5.
bool intersects(const Obb& box_a, const Obb& box_b);

/// Tests an axis-aligned box, given by its minimum and maximum, against an oriented one in the same
/// way.
bool intersects(const Aabb& aligned, const Obb& oriented);
bool intersects(const Obb& oriented, const Aabb& aligned);

}  // namespace graze

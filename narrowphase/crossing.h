#pragma once

#include <graze/narrowphase/touch.h>
#include <graze/narrowphase/triangle.h>

namespace graze {

/// True if and only if the relative interiors of the two triangles share a point and no plane holds
/// both triangles, in real arithmetic. The relative interior of a triangle with area is the
/// triangle without its edges; of one that is a segment, the segment without its ends; of a point,
/// the point. So two triangles with area cross where the inside of each goes through the other, a
/// segment crosses a triangle whose inside it pierces, and no other pair crosses: two segments that
/// meet, and a point with anything that it meets, lie in one plane. Exact for every finite double,
/// and the same for any order of triangles and vertices (law 4). Throws InputError for a coordinate
/// that is not finite.
bool crosses(const Triangle& triangle_a, const Triangle& triangle_b);

/// Answers intersects() or crosses(), as `touch` says. Throws InputError for a policy that is none.
bool intersects(const Triangle& triangle_a, const Triangle& triangle_b, Touch touch);

}  // namespace graze

#pragma once

#include <graze/narrowphase/convex/contact/touches.h>

namespace graze::narrowphase {

/// How a box, or a point with a radius, parts soonest from a triangle that it touches, by formula:
/// the box by the axes of both, as BoxAxes does, the point by where the triangle is nearest to
/// it. The way leads to the triangle. The triangle has an area.
Parting part_from_triangle(const Core& core, const Core& triangle);

/// The point of the triangle nearest to another.
/// Ericson, "Real-Time Collision Detection" (2005), 5.1.5.
Vec3 nearest_on_triangle(const Core& triangle, const Vec3& point);

}  // namespace graze::narrowphase

#pragma once

#include <graze/narrowphase/triangle.h>

namespace graze::narrowphase {

/// Says where a triangle crosses a line along a coordinate axis, seen from a point of the line.
enum class LineCrossing { None, Below, Above };

/// Finds where the triangle crosses the line along `axis` (0, 1 or 2) through the point that is
/// moved from `point` by (e, e^2, e^3) for an e > 0 too small to matter otherwise. The moved line
/// meets no edge and no vertex and lies in no plane of a triangle, and the moved point lies on no
/// triangle, so that crossings can be counted: the number of crossings above a point, taken modulo
/// 2, changes along a path exactly where the path goes through a closed surface. The answer is
/// exact for finite input, and undefined for any other. Edelsbrunner and Mücke, "Simulation of
/// simplicity", 1990.
LineCrossing cross_axis_line(const Triangle& triangle, const double* point, int axis);

}  // namespace graze::narrowphase

#pragma once

#include <graze/bvh/fit/methods/box_frame.h>
#include <graze/bvh/fit/methods/local_points.h>

namespace graze::bvh {

/// Returns the axes of DiTO-14, chosen by the surface of the box around the extremal points alone.
Axes ditetrahedron_axes(const LocalPoints& points);

}  // namespace graze::bvh

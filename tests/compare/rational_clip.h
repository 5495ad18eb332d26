#pragma once

#include <optional>

#include <graze/bvh/aabb.h>
#include <graze/narrowphase/triangle.h>

namespace graze::oracle {

/// The triangle cut by the six half-spaces of the box, in rationals: is anything left?
bool intersects_by_clipping(const Triangle& triangle, const Aabb& box);

/// Triangle A cut by the plane of triangle B from both sides and by the planes upright on B's
/// edges: is anything left? Nothing if B has no area, and so no plane.
std::optional<bool> intersects_by_clipping(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze::oracle

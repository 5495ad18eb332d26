#pragma once

#include <graze/bvh/aabb.h>

namespace graze::bvh {

/// A closed box of floats in the units and about the centre of a LocalFrame. Every float box holds
/// what it was made from: it is rounded outward (law 5).
struct FloatBox {
  float min[3];
  float max[3];
};

/// The box that every merge leaves unchanged: it holds nothing.
FloatBox empty_box();

/// The smallest box that holds both, exactly.
FloatBox merged(const FloatBox& a, const FloatBox& b);

/// True unless the closed boxes, in one frame, share no point.
bool overlap(const FloatBox& a, const FloatBox& b);

/// Half the surface of the box, in square local units: the measure of the surface area heuristic.
float half_surface(const FloatBox& box);

}  // namespace graze::bvh

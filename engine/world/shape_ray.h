#pragma once

#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/work.h>
#include <graze/engine/world/placed_shape.h>

#include <optional>

namespace graze {

/// Returns where the ray meets the placed shape first, or nothing if it does not. Convex shapes and
/// half-spaces are solid: a ray that begins in one meets it there, at distance 0, with a normal
/// against the ray. The answer for a mesh is exact, that of cast_ray() of a mesh. The answer for
/// any other shape is right for a shape whose faces are displaced by at most 2^-40 of the scale,
/// which is the shape's size and the distance of the ray's origin from its middle together: a ray
/// that comes as near to the surface as that may hit or miss. A ray through a shape that is thinner
/// than this hits it if it would also do so after it was moved by so much. A hull's middle lies
/// where law 1 places it, and all else of it is exact. Throws as check_ray() does, and PoseError
/// for a pose that is refused by law 10 or that moves the shape beyond kLargestLength. The function
/// is a template for the reason given in shape_pairs.h.
template <typename = void>
std::optional<RayHit> cast_ray(const PlacedShapeView& shape, const Ray& ray, Work* work = nullptr);

}  // namespace graze

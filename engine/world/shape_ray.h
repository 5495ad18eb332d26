#pragma once

#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/work.h>
#include <graze/engine/world/placed_shape.h>

#include <optional>

namespace graze {

/// Where the ray meets the placed shape first, if it does. Convex shapes and half-spaces are solid:
/// a ray that begins in one meets it there, at distance 0, with a normal against the ray. Of meshes
/// it is as of cast_ray() of a mesh, exact. Of the others the hit is one of a shape whose faces are
/// elsewhere by at most 2^-40 of the scale, which is the shape's size and how far the ray's origin
/// is from its middle: a ray that comes as near to the surface as that may be told either way. Of a
/// shape that is thinner than this, one that goes through and would still if it were moved by so
/// much hits. A hull's middle lies where law 1 places it, and all else of it is exact.
/// Throws as check_ray() does, and PoseError for a pose that is refused by law 10 or that moves the
/// shape beyond kLargestLength.
/// (A template for the reason given in shape_pairs.h.)
template <typename = void>
std::optional<RayHit> cast_ray(const PlacedShapeView& shape, const Ray& ray, Work* work = nullptr);

}  // namespace graze

#pragma once

#include <graze/bvh/ray.h>
#include <graze/narrowphase/triangle.h>
#include <Eigen/Core>

#include <optional>

namespace graze {

/// Says where a ray meets a triangle first.
struct TriangleRayHit {
  double distance;         ///< metres along the ray
  Eigen::Vector3d point;   ///< the point met, in the triangle's frame
  Eigen::Vector3d normal;  ///< the unit normal of the triangle on the side that the ray comes from;
                           ///< against the ray if the triangle has no area or the ray lies in its
                           ///< plane

  bool operator==(const TriangleRayHit&) const = default;
};

/// Returns where the ray meets the triangle first, or nothing. Whether the closed triangle and the
/// ray share a point is decided exactly, for all finite input, so that a ray through an edge or a
/// vertex meets each triangle there; it is a hit only if the distance as it is returned is also at
/// most the ray's largest. The distance is off by at most 4 ulp, and infinite if it is beyond the
/// largest double; the point by at most 4 ulp of the distance or the largest coordinate of the
/// ray's origin, whichever is larger; a component of the normal by at most 8 u, u = 2^-53. The
/// order of vertices changes no hit. Throws InputError for a coordinate that is not finite, and as
/// check_ray() does.
std::optional<TriangleRayHit> cast_ray(const Triangle& triangle, const Ray& ray);

}  // namespace graze

#pragma once

#include <graze/narrowphase/convex/core/core.h>

#include <optional>

namespace graze::narrowphase {

/// Says where a ray meets a placed convex set first.
struct CoreRayHit {
  double distance;  ///< metres along the ray from its origin; 0 if that lies in the set
  Vec3 normal;      ///< unit, outward; against the ray if the distance is 0
};

/// Casts a ray by closed forms: spheres and ellipsoids by the point of the line that is nearest to
/// the middle, capsules, cylinders and cones by their parts, boxes by slabs; hulls by hull_ray.h.
/// The scale is the core's bounding radius and radius and how far the ray's origin is from its
/// middle. A ray is found to meet the set, where it does, as it would meet one whose faces are
/// elsewhere by at most kRayTolerance of the scale: so a ray that comes as near to the surface as
/// that may count as a hit or as a miss, and the distance is that of such a set. `origin` is in the
/// core's frame, `direction` unit. Triangles are not for this function.
std::optional<CoreRayHit> cast_ray(const Core& core, const Vec3& origin, const Vec3& direction);

inline constexpr double kRayTolerance = 0x1p-40;

}  // namespace graze::narrowphase

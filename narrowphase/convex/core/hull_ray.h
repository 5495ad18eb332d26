#pragma once

// Finds where a ray meets a hull. The signs of ray/ decide that exactly for every hull.

#include <graze/narrowphase/convex/core/hull.h>

#include <optional>

namespace graze::narrowphase {

enum class HullRayStart {
  Here,       ///< the ray begins at the origin
  FarBehind,  ///< the ray begins before all of the hull: the origin is but a point of the line
};

struct HullRayHit {
  double distance;  ///< in lengths of the direction from the origin; 0 for a ray that begins in the
                    ///< hull
  Vec3 normal;      ///< the normal of a face there, if the ray does not begin in the hull
};

/// Casts along a line given in the hull's frame relative to its middle. Which face it enters by,
/// and on which side of faces it begins, is exact for these doubles and the hull's exact corners.
/// The distance is off by what moves a face by 400 u of the bounding radius and the origin's
/// distance where the ray meets it at more than 7 degrees, and else by an ulp or two. The direction
/// is of about unit length, the origin within ten bounding radii.
///
/// Half-spaces that hold the hull whatever was rounded say that most rays miss. For the others the
/// face whose plane is entered last, or one that is few edges away, is mostly met inside all of its
/// edges, surely. Else all faces that may be the one are asked, in integers where a rounded sign is
/// not sure. Takes O(f) for f faces.
std::optional<HullRayHit> cast_ray(const Hull& hull, const Vec3& origin, const Vec3& direction,
                                   HullRayStart start);

}  // namespace graze::narrowphase

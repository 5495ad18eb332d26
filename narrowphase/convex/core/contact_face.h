#pragma once

#include <graze/narrowphase/convex/core/core.h>

#include <cstdint>

namespace graze::narrowphase {

/// Holds the part of a set's boundary that faces a direction: a polygon, a segment or a point.
struct ContactFace {
  static constexpr int kMostCorners = 16;
  ContactFace() {}
  // The corners are in a union so that those beyond the count are not initialised: most are never
  // used.
  union {
    /// The corners in the common frame, on the boundary; counter-clockwise as seen from outside.
    Vec3 corner[kMostCorners];
  };
  std::uint32_t corner_id[kMostCorners];  ///< the numbers of the set's own corners, the same in
                                          ///< every pose
  int count = 0;
  Vec3 normal;            ///< unit, outward
  double unevenness = 0;  ///< how far some corner of a hull lies behind the plane that supports it
  /// For a hull this is the cosine between the direction that is faced and the next face's normal,
  /// and 1 if not all corners are here. All other sets have no near face beside it.
  double next_facing = -1;
  std::uint32_t id = 0;  ///< the number of the face among those of its set
};

/// Returns the face whose normal is nearest to a unit direction. A cap of a cylinder or a cone's
/// base is the regular octagon in it, fixed to the set; their sides, and a capsule's, are the
/// segment that faces the direction; a hull's face of more than kMostCorners is thinned out evenly.
ContactFace face_along(const Core& core, const Vec3& unit_direction);

}  // namespace graze::narrowphase

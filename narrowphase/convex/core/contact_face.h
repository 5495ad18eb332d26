#pragma once

#include <graze/narrowphase/convex/core/core.h>

#include <cstdint>

namespace graze::narrowphase {

/// The part of a set's boundary that faces a direction: a polygon, a segment or a point of it.
struct ContactFace {
  static constexpr int kMostCorners = 16;
  ContactFace() {}
  // In a union so that corners beyond the count are not initialised: most are never used.
  union {
    /// In the common frame, on the boundary; counter-clockwise as seen from outside.
    Vec3 corner[kMostCorners];
  };
  std::uint32_t corner_id[kMostCorners];  ///< of the set's own corners, the same in every pose
  int count = 0;
  Vec3 normal;            ///< unit, outward
  double unevenness = 0;  ///< of a hull: how far some corner lies behind the plane that supports it
  /// Of a hull: the cosine between the direction that is faced and the next face's normal; 1 if not
  /// all corners are here. All other sets have none that is near.
  double next_facing = -1;
  std::uint32_t id = 0;  ///< of the face among those of its set
};

/// The face whose normal is nearest to a unit direction. A cap of a cylinder or a cone's base is
/// the regular octagon in it, fixed to the set; their sides, and a capsule's, are the segment that
/// faces the direction; a hull's face of more than kMostCorners is thinned out evenly.
ContactFace face_along(const Core& core, const Vec3& unit_direction);

}  // namespace graze::narrowphase

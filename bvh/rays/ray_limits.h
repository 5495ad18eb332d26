#pragma once

// Limits of s as floats, seen from where a walk starts. Private. Functions are static so that each
// source compiles its own, with the flags of the floor.

#include <algorithm>

namespace graze::bvh {

// A conversion to float is off by 2^-24 of its result, and is exact where that underflows but for
// 2^-149. Below, so that no s within reach of the tree, 2^25, is infinite.
inline constexpr double kFloatShare = 0x1p-22;
inline constexpr double kFloatUnderflow = 0x1p-140;
inline constexpr double kFarthest = 0x1p100;

// The limit of a largest distance is a little above its s; so much below it s counts for sure, as
// distances are returned to within a few u.
inline constexpr double kSurely = 1 - 0x1p-40;

/// Not below s - start.
static inline float ray_limit(double s, double start) {
  const double seen = std::min(s - start, kFarthest);
  return static_cast<float>(seen + (std::max(seen, -seen) * kFloatShare + kFloatUnderflow));
}

/// Below all s that do not count for sure.
static inline float sure_ray_limit(double s, double start) {
  const double seen = std::min(kSurely * s - start, kFarthest);
  return static_cast<float>(seen - (std::max(seen, -seen) * kFloatShare + kFloatUnderflow));
}

}  // namespace graze::bvh

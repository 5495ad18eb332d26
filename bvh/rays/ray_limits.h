#pragma once

// These give limits of s as floats, seen from where a walk starts. They are private. Functions are
// static so that each source compiles its own, with the flags of the floor.

#include <algorithm>

namespace graze::bvh {

// A conversion to float is off by 2^-24 of its result, and is exact where that underflows but for
// 2^-149. The largest limit is so small that no s within reach of the tree, 2^25, is infinite.
inline constexpr double kFloatShare = 0x1p-22;
inline constexpr double kFloatUnderflow = 0x1p-140;
inline constexpr double kFarthest = 0x1p100;

// The limit for a largest distance is a little above its s; an s that is smaller by this share
// counts for sure, as distances are returned to within a few u.
inline constexpr double kSurely = 1 - 0x1p-40;

/// Returns a float that is not below s - start.
static inline float ray_limit(double s, double start) {
  const double seen = std::min(s - start, kFarthest);
  return static_cast<float>(seen + (std::max(seen, -seen) * kFloatShare + kFloatUnderflow));
}

/// Returns a float that is below all s that do not count for sure.
static inline float sure_ray_limit(double s, double start) {
  const double seen = std::min(kSurely * s - start, kFarthest);
  return static_cast<float>(seen - (std::max(seen, -seen) * kFloatShare + kFloatUnderflow));
}

}  // namespace graze::bvh

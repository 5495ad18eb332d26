#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/value/float_box.h>

namespace graze::bvh {

/// The frame in which the float boxes of a tree live: local = (x - centre) / 2^exponent (law 5).
/// The frame is made for a box, in which local coordinates are between -2 and 2, so that the
/// relative precision of a float serves meshes at any offset and of any size.
struct LocalFrame {
  double centre[3];
  int exponent;  ///< at least kMinExponent

  /// The least exponent: below it local coordinates simply become small.
  static constexpr int kMinExponent = -1000;

  static LocalFrame around(const Aabb& box);

  /// Returns the box in local coordinates, rounded outward.
  FloatBox to_local(const Aabb& box) const;

  /// Returns 2^exponent, metres per local unit.
  double unit() const;
};

/// Return a float that is certainly below (above) `value` and above (below) all that is two floats
/// away. A step is always taken: asking whether the rounding went the wrong way is what g++ 12.2
/// optimises away in vectorised code.
float rounded_down(double value);
float rounded_up(double value);

}  // namespace graze::bvh

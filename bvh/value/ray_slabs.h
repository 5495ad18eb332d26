#pragma once

// This compares a ray with boxes, for the loops that walk trees. It is private. Functions are
// static so that each source compiles its own, with the flags of the floor.

#include <graze/bvh/ray.h>
#include <graze/bvh/value/power_of_two.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {

/// A direction times a power of two that brings its largest component into [1, 2). Components that
/// underflow are off by less than 2^-1074.
struct ScaledDirection {
  double component[3];
  int exponent;  ///< direction = component * 2^exponent
};

/// Returns the length of its components: between 1 and 3.5, off by at most 2 u of itself.
static inline double length_of(const ScaledDirection& scaled) {
  const double* c = scaled.component;
  return std::sqrt((c[0] * c[0] + c[1] * c[1]) + c[2] * c[2]);
}

static inline ScaledDirection scaled_direction(const double* direction) {
  const double largest =
      std::max(std::abs(direction[0]), std::max(std::abs(direction[1]), std::abs(direction[2])));
  ScaledDirection scaled;
  scaled.exponent = exponent_of(largest);
  // One product does where the power of two is a normal double, which is what nearly all rays have.
  if (std::abs(scaled.exponent) < 1000) [[likely]] {
    const double power = power_of_two(-scaled.exponent);
    for (int k = 0; k < 3; ++k)
      scaled.component[k] = direction[k] * power;
  } else {
    for (int k = 0; k < 3; ++k)
      scaled.component[k] = std::scalbn(direction[k], -scaled.exponent);
  }
  return scaled;
}

/// The points origin + s direction, s >= 0, as they are compared with boxes. The direction's
/// largest component is between 1/2 and 4. A component below 2^-60 is taken for 0: whoever asks
/// grows the boxes by 2^-58 of how far they reach from the origin, at least, which covers that.
inline constexpr double kParallel = 0x1p-60;
struct RaySlabs {
  RaySlabs() = default;
  RaySlabs(const double* ray_origin, const double* ray_direction) {
    for (int k = 0; k < 3; ++k) {
      origin[k] = ray_origin[k];
      is_parallel[k] = std::abs(ray_direction[k]) < kParallel;
      inverse[k] = is_parallel[k] ? 1 : 1 / ray_direction[k];
    }
  }

  double origin[3];
  double inverse[3];
  bool is_parallel[3];
};

/// The answer of entry() for a box that the ray does not meet.
inline constexpr double kNever = -1;

// The s at which the ray crosses a face is rounded three times (a difference, the inverse, their
// product) and each time to a value of the same sign: off by a factor within 1 +- 4 u, or by an
// underflow. What overflows becomes infinite on its own side. No operation makes a NaN: origin and
// inverse are finite, the inverse is not 0.

/// Returns a value that is not above any s between both, which are rounded so; kNever only if there
/// is none.
static inline double surely_entered(double enter, double exit) {
  constexpr double kRounding = 0x8p-53;
  constexpr double kUnderflow = 0x1p-1060;
  const double surely_before = enter * (1 - kRounding) - kUnderflow;
  if (surely_before > exit * (1 + kRounding) + kUnderflow) return kNever;
  return std::max(surely_before, 0.0);
}

/// Returns a value that is not above any s in [0, limit] at which the ray is in the closed box;
/// kNever only if there is none. The box may be infinite.
static inline double entry(const RaySlabs& ray, const double* low, const double* high,
                           double limit) {
  double enter = 0;
  double exit = limit;
  for (int k = 0; k < 3; ++k) {
    if (ray.is_parallel[k]) {
      if (ray.origin[k] < low[k] || ray.origin[k] > high[k]) return kNever;
      continue;
    }
    const double at_low = (low[k] - ray.origin[k]) * ray.inverse[k];
    const double at_high = (high[k] - ray.origin[k]) * ray.inverse[k];
    enter = std::max(enter, std::min(at_low, at_high));
    exit = std::min(exit, std::max(at_low, at_high));
  }
  return surely_entered(enter, exit);
}

}  // namespace graze::bvh

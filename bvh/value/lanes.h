#pragma once

#include <graze/bvh/value/float_box.h>
#include <bit>
#include <cstdint>

namespace graze::bvh {

/// Four floats in a register of any CPU: compilers make one instruction of each operation, at the
/// baseline as well, and round each lane as they round a float. What follows is static for the
/// reason given in float_box.h.
using Lanes = float __attribute__((vector_size(16)));
using IntLanes = std::int32_t __attribute__((vector_size(16)));

static inline Lanes all_lanes(float value) {
  return Lanes{value, value, value, value};
}

/// Returns lane by lane the larger one, and `b` where `a` is NaN.
static inline Lanes larger(Lanes a, Lanes b) {
  return a > b ? a : b;
}

static inline Lanes smaller(Lanes a, Lanes b) {
  return a < b ? a : b;
}

/// Returns `a` in the lanes whose mask is -1, `b` where it is 0.
static inline IntLanes chosen(IntLanes mask, IntLanes a, IntLanes b) {
  return (mask & a) | (~mask & b);
}

static inline Lanes chosen(IntLanes mask, Lanes a, Lanes b) {
  return std::bit_cast<Lanes>(chosen(mask, std::bit_cast<IntLanes>(a), std::bit_cast<IntLanes>(b)));
}

/// A FloatBox with its minimum negated, so that one operation, the larger of two, merges both of
/// its corners. The fourth lanes mean nothing.
struct Bounds {
  Lanes minus_min;
  Lanes max;
};

static inline Bounds empty_bounds() {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return {all_lanes(-kInfinity), all_lanes(-kInfinity)};
}

static inline Bounds merged(const Bounds& a, const Bounds& b) {
  return {larger(a.minus_min, b.minus_min), larger(a.max, b.max)};
}

static inline Lanes size_of(const Bounds& box) {
  return box.max + box.minus_min;
}

/// Returns twice the centre: order is all that matters. The fourth lane is zero.
static inline Lanes centroid_of(const Bounds& box) {
  constexpr IntLanes kThree = {-1, -1, -1, 0};
  return std::bit_cast<Lanes>(std::bit_cast<IntLanes>(box.max - box.minus_min) & kThree);
}

static inline FloatBox float_box(const Bounds& box) {
  return {{-box.minus_min[0], -box.minus_min[1], -box.minus_min[2]},
          {box.max[0], box.max[1], box.max[2]}};
}

}  // namespace graze::bvh

#pragma once

#include <graze/bvh/value/lanes.h>
#include <graze/bvh/value/local_frame.h>
#include <graze/bvh/value/point_pairs.h>
#include <cmath>

namespace graze::bvh {

/// Does LocalFrame::to_local() for many boxes: it makes the same floats, in registers.
class ToLocal {
 public:
  explicit ToLocal(const LocalFrame& frame)
      : centre_(load_point(frame.centre)), scale_(std::ldexp(1.0, -frame.exponent)) {}

  /// Returns the local box with these corners of three coordinates each.
  Bounds box(const double* min, const double* max) const {
    return local(load_point(min), load_point(max));
  }

  /// Returns the local box around three points.
  Bounds box(const double* a, const double* b, const double* c) const {
    const PointPairs p = load_point(a);
    const PointPairs q = load_point(b);
    const PointPairs r = load_point(c);
    return local(smaller(smaller(p, q), r), larger(larger(p, q), r));
  }

 private:
  /// Rounds a local box outward. Rounding to nearest is the same for a number and its negative.
  Bounds local(const PointPairs& min, const PointPairs& max) const {
    return {rounded_up(-nearest(min)), rounded_up(nearest(max))};
  }

  Lanes nearest(const PointPairs& p) const {
    const Pair xy = (p.xy - centre_.xy) * Pair{scale_, scale_};
    const Pair yz = (p.yz - centre_.yz) * Pair{scale_, scale_};
    using Floats = float __attribute__((vector_size(8)));
    return __builtin_shufflevector(__builtin_convertvector(xy, Floats),
                                   __builtin_convertvector(yz, Floats), 0, 1, 3, 3);
  }

  /// Does bvh::rounded_up() lane by lane: it takes the nearest floats and returns the next ones
  /// towards infinity.
  static Lanes rounded_up(Lanes nearest) {
    const IntLanes bits = std::bit_cast<IntLanes>(nearest);
    const IntLanes one = {1, 1, 1, 1};
    const IntLanes is_zero = nearest == all_lanes(0);
    // Unsigned, because the bits of -0 have no predecessor: those lanes are not chosen.
    using Bits = std::uint32_t __attribute__((vector_size(16)));
    const Bits next = std::bit_cast<Bits>(bits) + std::bit_cast<Bits>((bits >> 31) | one);
    return std::bit_cast<Lanes>(chosen(is_zero, one, std::bit_cast<IntLanes>(next)));
  }

  PointPairs centre_;
  double scale_;
};

}  // namespace graze::bvh

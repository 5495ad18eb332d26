#pragma once

#include <graze/bvh/lanes.h>
#include <graze/bvh/local_frame.h>
#include <cmath>
#include <cstring>

namespace graze::bvh {

/// LocalFrame::to_local() for many boxes: the same floats, made in registers.
class ToLocal {
 public:
  explicit ToLocal(const LocalFrame& frame)
      : centre_(point(frame.centre)), scale_(std::ldexp(1.0, -frame.exponent)) {}

  /// Of the box with these corners of three coordinates each.
  Bounds box(const double* min, const double* max) const { return local(point(min), point(max)); }

  /// Of the box around three points.
  Bounds box(const double* a, const double* b, const double* c) const {
    const Point p = point(a);
    const Point q = point(b);
    const Point r = point(c);
    return local({smaller(smaller(p.xy, q.xy), r.xy), smaller(smaller(p.yz, q.yz), r.yz)},
                 {larger(larger(p.xy, q.xy), r.xy), larger(larger(p.yz, q.yz), r.yz)});
  }

 private:
  using Pair = double __attribute__((vector_size(16)));

  /// y twice, so that both are loaded as they lie in memory.
  struct Point {
    Pair xy;
    Pair yz;
  };

  static Point point(const double* coordinates) {
    Point p;
    std::memcpy(&p.xy, coordinates, sizeof(Pair));
    std::memcpy(&p.yz, coordinates + 1, sizeof(Pair));
    return p;
  }

  static Pair smaller(Pair a, Pair b) { return a < b ? a : b; }
  static Pair larger(Pair a, Pair b) { return a > b ? a : b; }

  // Rounding to nearest is the same for a number and its negative.
  Bounds local(const Point& min, const Point& max) const {
    return {rounded_up(-nearest(min)), rounded_up(nearest(max))};
  }

  Lanes nearest(const Point& p) const {
    const Pair xy = (p.xy - centre_.xy) * Pair{scale_, scale_};
    const Pair yz = (p.yz - centre_.yz) * Pair{scale_, scale_};
    using Floats = float __attribute__((vector_size(8)));
    return __builtin_shufflevector(__builtin_convertvector(xy, Floats),
                                   __builtin_convertvector(yz, Floats), 0, 1, 3, 3);
  }

  /// bvh::rounded_up() lane by lane, from what is nearest: the next float towards infinity.
  static Lanes rounded_up(Lanes nearest) {
    const IntLanes bits = std::bit_cast<IntLanes>(nearest);
    const IntLanes one = {1, 1, 1, 1};
    const IntLanes is_zero = nearest == all_lanes(0);
    return std::bit_cast<Lanes>(chosen(is_zero, one, bits + ((bits >> 31) | one)));
  }

  Point centre_;
  double scale_;
};

}  // namespace graze::bvh

// Compiles look_at_pair() for each SIMD target that the compiler knows; the widest that the CPU has
// is chosen when the program runs. Lanes are the compiler's own, four doubles of which three are
// used: Highway 1.0.3 has no vectors of a fixed four for every target, and a compiler makes two
// registers of what does not fit one. No operation is fused, and of those that decide each is in
// its place in obb_overlap.cpp, bvh/value/rigid.h and bvh/value/separating_axes.h, so that all
// round alike.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/narrowphase/volumes/boxes/obb_pair_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/pose.h>
#include <graze/narrowphase/volumes/boxes/obb_pair_kernels.h>
#include <graze/narrowphase/volumes/boxes/obb_slack.h>
#include <hwy/highway.h>
#include <cstdint>
#include <cstring>
#include <limits>

// No quad leaves the functions below, which are inlined: how one is passed does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

HWY_BEFORE_NAMESPACE();
namespace graze::narrowphase::HWY_NAMESPACE {
namespace {

using Quad = double __attribute__((vector_size(32)));
using QuadMask = std::int64_t __attribute__((vector_size(32)));

HWY_INLINE Quad all(double value) {
  return Quad{value, value, value, value};
}

HWY_INLINE Quad load_four(const double* from) {
  Quad quad;
  std::memcpy(&quad, from, sizeof quad);
  return quad;
}

HWY_INLINE Quad size_of(const Quad& v) {
  return reinterpret_cast<Quad>(reinterpret_cast<QuadMask>(v) &
                                std::numeric_limits<std::int64_t>::max());
}

/// Lane i has the number of axis i + 1.
HWY_INLINE Quad next(const Quad& v) {
  return __builtin_shufflevector(v, v, 1, 2, 0, 3);
}

/// Lane i has the number of axis i + 2.
HWY_INLINE Quad second_next(const Quad& v) {
  return __builtin_shufflevector(v, v, 2, 0, 1, 3);
}

/// True if the mask is set in one of the lanes 0 to 2.
HWY_INLINE bool any_of_three(const QuadMask& mask) {
  return ((mask[0] | mask[1]) | mask[2]) != 0;
}

/// Holds a box as its pose has it: axis i in axes[i], and lane i of row[k] has its coordinate k.
struct Box {
  Quad axes[3];
  Quad translation;
  Quad row[3];
  Quad half;
  double sum;
  double deviation;  ///< the deviation from a rotation
  QuadMask invalid;  ///< not zero in a lane where something keeps the box from being valid
};

HWY_INLINE Box load_box(const Obb& box, double sum) {
  const double* m = box.pose.data();  // column-major 4x4
  const double* h = box.half_extents.data();
  Box result{{load_four(m), load_four(m + 4), load_four(m + 8)},
             load_four(m + 12),
             {},
             {h[0], h[1], h[2], 0},
             sum,
             0,
             {}};
  const Quad x_z_01 = __builtin_shufflevector(result.axes[0], result.axes[1], 0, 4, 2, 6);
  const Quad y_w_01 = __builtin_shufflevector(result.axes[0], result.axes[1], 1, 5, 3, 7);
  const Quad x_z_2t = __builtin_shufflevector(result.axes[2], result.translation, 0, 4, 2, 6);
  const Quad y_w_2t = __builtin_shufflevector(result.axes[2], result.translation, 1, 5, 3, 7);
  result.row[0] = __builtin_shufflevector(x_z_01, x_z_2t, 0, 1, 4, 5);
  result.row[1] = __builtin_shufflevector(y_w_01, y_w_2t, 0, 1, 4, 5);
  result.row[2] = __builtin_shufflevector(x_z_01, x_z_2t, 2, 3, 6, 7);
  const Quad last_row = __builtin_shufflevector(y_w_01, y_w_2t, 2, 3, 6, 7);
  const Quad x = result.row[0], y = result.row[1], z = result.row[2];
  const Quad of_lengths = size_of((x * x + y * y + z * z) - all(1));
  const Quad next_x = next(x), next_y = next(y), next_z = next(z);
  const Quad of_angles = size_of(x * next_x + y * next_y + z * next_z);
  const Quad most = of_lengths > of_angles ? of_lengths : of_angles;
  const double most_of_two = most[0] > most[1] ? most[0] : most[1];
  result.deviation = most_of_two > most[2] ? most_of_two : most[2];
  // Each comparison fails for NaN. The determinant is the sum of the lanes of x times the cross
  // product of y and z, close to +1 or -1 where the rest is valid.
  const Quad minors = x * (next_y * second_next(z) - second_next(y) * next_z);
  const Quad largest = all(std::numeric_limits<double>::max());
  const Quad limit = all(kMaxRotationDeviation);
  QuadMask valid = (of_lengths <= limit) & (of_angles <= limit);
  valid &= (size_of(result.translation) <= largest) & (result.half >= all(0)) &
           (result.half <= largest) & (all(minors[0] + minors[1] + minors[2]) > all(0)) &
           (all(last_row[3]) == all(1)) & (last_row == all(0));
  result.invalid = ~valid;
  return result;
}

/// Returns slack() of obb_overlap.cpp, for sums in its range.
HWY_INLINE double slack_in_range(const Box& a, const Box& b) {
  const double deviating = a.deviation * (kDeviationOfA * a.sum + kDeviationOfAOnB * b.sum) +
                           b.deviation * (kDeviationOfB * b.sum);
  return (deviating + (kRoundingOfA * a.sum + kRoundingOfB * b.sum)) + kObbUnderflow;
}

/// Holds box B in the frame of A.
struct InFrame {
  Quad column[3];  ///< axis j of B, a lane for each axis of A
  Quad row[3];     ///< the same, a lane for each axis of B
  Quad offset;     ///< from the middle of A to that of B, a lane for each axis of A
};

HWY_INLINE InFrame in_frame(const Box& a, const Box& b) {
  InFrame frame;
  for (int i = 0; i < 3; ++i) {
    const Quad of_b = b.axes[i], of_a = a.axes[i];
    frame.column[i] = a.row[0] * all(of_b[0]) + a.row[1] * all(of_b[1]) + a.row[2] * all(of_b[2]);
    frame.row[i] = all(of_a[0]) * b.row[0] + all(of_a[1]) * b.row[1] + all(of_a[2]) * b.row[2];
  }
  const Quad between = b.translation - a.translation;
  frame.offset =
      a.row[0] * all(between[0]) + a.row[1] * all(between[1]) + a.row[2] * all(between[2]);
  return frame;
}

HWY_INLINE QuadMask apart_by_faces(const InFrame& f, const Box& a, const Box& b,
                                   const Quad& margin) {
  const Quad radius_a = a.half + all(b.half[0]) * size_of(f.column[0]) +
                        all(b.half[1]) * size_of(f.column[1]) +
                        all(b.half[2]) * size_of(f.column[2]);
  const Quad distance_b =
      all(f.offset[0]) * f.row[0] + all(f.offset[1]) * f.row[1] + all(f.offset[2]) * f.row[2];
  const Quad radius_b = b.half + all(a.half[0]) * size_of(f.row[0]) +
                        all(a.half[1]) * size_of(f.row[1]) + all(a.half[2]) * size_of(f.row[2]);
  return (size_of(f.offset) > radius_a + margin) | (size_of(distance_b) > radius_b + margin);
}

HWY_INLINE QuadMask apart_by_edges(const InFrame& f, const Box& a, const Box& b,
                                   const Quad& margin) {
  const Quad half_1 = next(b.half), half_2 = second_next(b.half);
  QuadMask apart{};
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    const Quad size = size_of(f.row[i]);
    const Quad distance = all(f.offset[i2]) * f.row[i1] - all(f.offset[i1]) * f.row[i2];
    const Quad radius = all(a.half[i1]) * size_of(f.row[i2]) +
                        all(a.half[i2]) * size_of(f.row[i1]) + half_1 * second_next(size) +
                        half_2 * next(size);
    apart |= size_of(distance) > radius + margin;
  }
  return apart;
}

/// Looks at two boxes in order: `larger` has the larger sum of half extents, and is A in the terms
/// of obb_slack.h.
ObbPairAnswer look_in_order(const Obb& larger, double sum_a, const Obb& smaller, double sum_b) {
  const Box a = load_box(larger, sum_a), b = load_box(smaller, sum_b);
  if (any_of_three(a.invalid | b.invalid)) return ObbPairAnswer::Open;
  const Quad margin = all(slack_in_range(a, b));
  const InFrame frame = in_frame(a, b);
  const QuadMask by_faces = apart_by_faces(frame, a, b, margin);
  const bool is_apart = any_of_three(by_faces | apart_by_edges(frame, a, b, margin));
  return is_apart ? ObbPairAnswer::Apart : ObbPairAnswer::MayOverlap;
}

}  // namespace
}  // namespace graze::narrowphase::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::narrowphase {
namespace {

HWY_EXPORT(look_in_order);

double sum_of_halves(const Obb& box) {
  const double* half = box.half_extents.data();
  return (half[0] + half[1]) + half[2];
}

}  // namespace

ObbPairAnswer look_at_pair(const Obb& box_a, const Obb& box_b) {
  const double sum_a = sum_of_halves(box_a), sum_b = sum_of_halves(box_b);
  if (!(sum_a + sum_b <= kLargestObbSum) || sum_a == sum_b) return ObbPairAnswer::Open;
  const bool is_second = sum_a < sum_b;
  const Obb* larger = is_second ? &box_b : &box_a;
  const Obb* smaller = is_second ? &box_a : &box_b;
  return HWY_DYNAMIC_DISPATCH(look_in_order)(*larger, is_second ? sum_b : sum_a, *smaller,
                                             is_second ? sum_a : sum_b);
}

}  // namespace graze::narrowphase
#endif

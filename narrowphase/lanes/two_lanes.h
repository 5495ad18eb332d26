#pragma once

// Computes with two doubles at once, on the baseline SIMD of any CPU that has some: vector
// extensions, which gcc and clang share. Each lane rounds as a double does.

#include <cstdint>
#include <limits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace graze::narrowphase {

using TwoLanes = double __attribute__((vector_size(16)));
using TwoMasks = std::int64_t __attribute__((vector_size(16)));

inline TwoLanes both(double value) {
  return TwoLanes{value, value};
}

/// Loads two numbers that lie side by side.
inline TwoLanes load(const double* p) {
  return TwoLanes{p[0], p[1]};
}

inline TwoLanes swapped(TwoLanes v) {
  return __builtin_shufflevector(v, v, 1, 0);
}

inline TwoLanes larger(TwoLanes a, TwoLanes b) {
  return a > b ? a : b;
}

inline TwoLanes smaller(TwoLanes a, TwoLanes b) {
  return a < b ? a : b;
}

inline TwoLanes magnitude(TwoLanes v) {
  constexpr std::int64_t kAllButSign = 0x7fffffffffffffff;
  return reinterpret_cast<TwoLanes>(reinterpret_cast<TwoMasks>(v) &
                                    TwoMasks{kAllButSign, kAllButSign});
}

/// Changes the signs of the lanes whose bits are set in `which`.
inline TwoLanes negated(TwoLanes v, unsigned which) {
  constexpr std::int64_t kSign = std::numeric_limits<std::int64_t>::min();
  constexpr TwoMasks kMasks[4] = {TwoMasks{0, 0}, TwoMasks{kSign, 0}, TwoMasks{0, kSign},
                                  TwoMasks{kSign, kSign}};
  return reinterpret_cast<TwoLanes>(reinterpret_cast<TwoMasks>(v) ^ kMasks[which]);
}

/// Returns a mask for both_of() and sign_bits(): all bits of a lane are set where a > b, none
/// elsewhere.
inline TwoLanes are_greater(TwoLanes a, TwoLanes b) {
#ifdef __SSE2__
  return _mm_cmpgt_pd(a, b);  // gcc takes (a > b) & (c > d) apart and computes with single lanes
#else
  return reinterpret_cast<TwoLanes>(a > b);
#endif
}

inline TwoLanes both_of(TwoLanes mask_a, TwoLanes mask_b) {
  return reinterpret_cast<TwoLanes>(reinterpret_cast<TwoMasks>(mask_a) &
                                    reinterpret_cast<TwoMasks>(mask_b));
}

inline TwoLanes either_of(TwoLanes mask_a, TwoLanes mask_b) {
  return reinterpret_cast<TwoLanes>(reinterpret_cast<TwoMasks>(mask_a) |
                                    reinterpret_cast<TwoMasks>(mask_b));
}

/// Returns the sign bits: bit i is that of lane i, set for negative numbers, and in masks for true.
inline unsigned sign_bits(TwoLanes v) {
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_pd(v));
#else
  const TwoMasks bits = reinterpret_cast<TwoMasks>(v);
  return static_cast<unsigned>((bits[0] < 0 ? 1 : 0) | (bits[1] < 0 ? 2 : 0));
#endif
}

struct TwoVectors {
  TwoLanes x, y, z;
};

inline TwoVectors operator-(const TwoVectors& a, const TwoVectors& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline TwoVectors cross(const TwoVectors& a, const TwoVectors& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline TwoLanes dot(const TwoVectors& a, const TwoVectors& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace graze::narrowphase

#pragma once

// The axes of the triangle/box test that need arithmetic, and the error bounds of its rounded
// stages: one pair at a time and many at once. Notation as in predicates.cpp: u is the unit
// roundoff, n the smallest double.
//
// S is the sum of the absolute values of all fifteen coordinates: one number that bounds all sizes,
// and that no infinity or NaN hides from. c and h are the box's rounded centre and half size,
// v = vertex - c, f the edges, and K, M, V, H, F the largest absolute components of the triangle's
// corners, the box's corners, v, h and f. H <= M, V <= K + M <= S. c is off by at most u M, hence v
// by u (M + V); h by u H; f by u F. F is at most 2 V, up to such errors.

#include <graze/narrowphase/predicates/verdict.h>

namespace graze::narrowphase {

// The axis e_i x f, with j, k after i: p = f_k v_j - f_j v_k of an end of the edge is off by
// 2 * 3 u F V from its roundings and 2 F u (M + V) from v. The vertex opposite to the edge has
// p - m there, where m is component i of the normal f_0 x f_1, for all three edges: the triangle
// projects to the interval of radius |m| / 2 about p - m / 2. m / 2, at most F^2, is off by 4 u F^2
// <= 8 u F V, and is used twice. The box's radius r = h_j |f_k| + h_k |f_j| is off by 8 u F H. The
// gap |p - m / 2| - (|m| / 2 + r) rounds a difference of at most 2 F V, a sum of 2 F V + 2 F H, and
// a difference of 2 F (V + H). In all u F (30 V + 2 M + 12 H) <= u F (30 K + 44 M) <= 44 u F S;
// the rest of 46 covers second orders, the rounding of S and of the bound, and underflow of six
// products.
inline constexpr double kEdgeBound = 46 * 0x1p-53;

// The normal: n = f_0 x f_1 has components up to 2 F^2, off by 8.1 u F^2. d = n . v is off by
// 3 (8.1 u F^2 V + 2 F^2 u (M + V)) and 18 u F^2 V from its own roundings: u F^2 (48.3 V + 6 M).
// The radius likewise by 48.3 u F^2 H. Comparing rounds a difference of size 6 F^2 (V + H). In all
// u F^2 (54.3 V + 6 M + 54.3 H) <= u F^2 (54.3 K + 114.6 M) <= 114.6 u F^2 S.
inline constexpr double kNormalBound = 120 * 0x1p-53;

// S at most 2^150: no overflow. F and S at least 2^-250: both bounds are above 2^-800, the
// underflow of products, n / 2 each, times V at most, below 2^-900.
inline constexpr double kLargestBoxSize = 0x1p+150;
inline constexpr double kSmallestBoxSize = 0x1p-250;

/// Tests the triangle's normal and the nine cross products of edges, of the thirteen axes of
/// Akenine-Möller's test, in rounded arithmetic; along the other three the two must overlap. Takes
/// the triangle's nine coordinates, the box's minimum and maximum, and the sum of the absolute
/// values of all fifteen, which is finite.
Verdict triage_remaining_axes(const double* t, const double* low, const double* high, double size);

}  // namespace graze::narrowphase

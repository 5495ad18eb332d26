#pragma once

// What the stages of the triangle test share: one error bound for all determinants of its rounded
// stages, one pair at a time and many at once, and what coordinates alone decide. Notation as in
// orientation_filter.cpp: u is the unit roundoff, n the smallest double.

#include <graze/narrowphase/triangle.h>
#include <graze/narrowphase/verdict.h>

namespace graze::narrowphase {

// X, Y, Z are the extents of the six vertices together, largest minus smallest coordinate, rounded.
// Every difference of two of them is at most X, Y, Z even after rounding, which is monotonic. A
// determinant ((b - a) x (c - a)) . (d - a) of any four of the six, computed as written or with its
// arguments in another order, is a sum of six monomials, each at most X Y Z, and carries eight
// roundings in each: three differences, two products, the inner difference and two sums. Exact
// differences are at most (1 + 1.01 u) times X, Y, Z; the error is at most 6 * 8.0001 u (1 + 4 u)
// X Y Z, and X Y Z as computed lacks two roundings: 48.01 u X Y Z.
//
// Underflow: six products lose n / 2 each and are multiplied by at most X, three more lose n / 2:
// 3 n X + 1.5 n, with X <= 2^150 below 2^-922. For X Y Z >= 2^-850 the spare 0.99 u X Y Z is above
// 2^-904. It also covers the rounding of the bound.
inline constexpr double kPairBound = 49 * 0x1p-53;
inline constexpr double kSmallestPairVolume = 0x1p-850;
inline constexpr double kLargestExtent = 0x1p+150;

/// What can be known of two triangles without arithmetic, exactly: triangles that share a vertex
/// touch, those whose boxes do not are apart. Not finite input is Unsure.
Verdict compare_coordinates(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze::narrowphase

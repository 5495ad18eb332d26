#pragma once

// The error bound by which rounded squares of distances are compared, for one pair at a time and
// for many at once. Notation as in orientation_filter.cpp: u is the unit roundoff, n the smallest
// double.

namespace graze::narrowphase {

// s = (x x + y y) + z z, with x, y, z differences of inputs, and q = r r, with r an input or a sum
// of two. Each difference carries one rounding, hence each square three, and the sums two more: s
// is off by at most (1 + u)^5 - 1 < 5.0001 u of the exact value, 5.001 u s of the computed one; q
// by at most 3.001 u q. Comparing s - q with 8 u (s + q) + 2^-1000 rounds four times more: 2.001 u
// (s + q), and u 2^-1000. Four products may underflow, and the bound's own: 2.5 n, far below
// 2^-1000.
//
// What overflows is unsure by itself: then the bound is infinite, or NaN, and nothing exceeds it.
inline constexpr double kSquareBound = 8 * 0x1p-53;
inline constexpr double kSquareUnderflow = 0x1p-1000;

}  // namespace graze::narrowphase

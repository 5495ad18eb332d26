#pragma once

// The error bound of the triangle test's six plane determinants, for its rounded stage, one pair at
// a time and many at once. Notation as in orientation_filter.cpp: u is the unit roundoff, n the
// smallest double.

namespace graze::narrowphase {

// A determinant is the sum of six monomials e_i f_j d_k: two edges of the plane's triangle and the
// way from it to a vertex of the other. Each carries eight roundings, as in orientation_filter.cpp:
// at most 8.0001 u. With E and D the largest components of edges and ways, S = E_y E_z D_x + E_z
// E_x D_y
// + E_x E_y D_z bounds half of the monomials: the error is at most 16.0002 u S. S itself is
// computed within (1 + u)^7, so 16.1 u S; the rest pays for underflow: the products lose at most n
// (D_x + D_y + D_z) + 1.5 n, and S as computed lacks at most as much again. With D <= 2^150 that is
// below 2^-921, and for S >= 2^-850 the spare 0.9 u S is above 2^-904.
inline constexpr double kPlaneBound = 17 * 0x1p-53;
inline constexpr double kSmallestPlaneSize = 0x1p-850;
inline constexpr double kLargestDifference = 0x1p+150;

}  // namespace graze::narrowphase

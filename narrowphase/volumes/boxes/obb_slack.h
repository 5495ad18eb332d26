#pragma once

// The slack of the separating axis test for two oriented boxes. Private: what single tests and
// kernels share.
//
// u = 2^-53; |v| is the 2-norm. Box A has the matrix R_A, the translation t_A, the half extents h_A
// with the sum S_A, and deviates from a rotation by dev_A = max |R_A^T R_A - I|, measured with an
// error below 4 u; B likewise; S = S_A + S_B. Suppose that a point p lies in both boxes, each read
// in any of three ways:
//   image     p = t + R y, |y_i| <= h_i;
//   transpose |R^T (p - t)|_i <= h_i;
//   law 3     p is a double and its rounded coordinates R^T (p - t) are within h: these are off by
//             4.02 u |p - t| <= 4.1 u S each, and underflow.
// Then for every axis L of the test |L . T| <= radius + slack holds as computed, where the radius
// is the sum of the two projected radii. All dev are below 1.1e-6, so that terms of second order
// vanish in the last digits given here.
//
// Frame. z = R_A^T (p - t_A) = a + e_a with |a_i| <= h_A,i and |e_a| <= 1.74 (dev_A + 5 u) S_A: for
// the image, R_A^T R_A y is off from y by dev_A S_A a component. And z = T + C b + e_b with T =
// R_A^T (t_B - t_A), C = R_A^T R_B, |b_j| <= h_B,j: for the image e_b = 0; otherwise p - t_B =
// R_B^-T w is off from R_B w by R_B^-T (I - R_B^T R_B) w, so |e_b| <= 1.74 (dev_B + 5 u) S_B.
//
// Rounding of the frame. p is in both boxes, so |t_B - t_A| <= 1.0001 S; T as computed is off by
// 7.01 u S. C as computed is off by 3.01 u an entry, C b by 5.22 u S_B. So with T and C as computed
// from here on, T + C b - a = e with
//   |e| <= 1.74 (dev_A + 5 u) S_A + 1.74 (dev_B + 5 u) S_B + 7.01 u S + 5.22 u S_B.
//
// Axes. |L| <= 1.0001, so L . T is off by 1.0001 |e| from the sum of the exact projected radii
// along L. For axis i of A, L = e_i, the test's radius is that sum. For axis j of B, L = C_j, it
// takes C_j . C_k for 0 or 1: off by g = max |C^T C - I| <= 3.01 dev_A + dev_B + 11 u (R_A R_A^T -
// I has the spectral norm of R_A^T R_A - I), in all g S_B. For e_i x C_j it takes e_i . (C_j x C_k)
// for +-C_il; C_j x C_k = det(C) C (C^T C)^-1 e_l is off from C_l by (1.5 + sqrt 3) g < 3.3 g; in
// all 3.3 g S_B, the most.
//
// Rounding of the test: 3.1 u S for the distance (again |T| <= 1.0001 S), 5.1 u S for the radius
// and its sum with the slack.
//
// The sum, with dev measured, hence 4 u more:
//   dev_A (1.75 S_A + 9.94 S_B) + 5.05 dev_B S_B + 31 u S_A + 126 u S_B.
// Of underflow, 2^-1075 for each product, there are fewer than 30 products: 2^-1070. Nothing
// overflows while S <= 2^1000. Beyond that the slack is infinite, and nothing is apart. When no
// point is shared, whatever overflows makes a distance infinite or NaN: apart, which is true, or
// not.
//
// Axis-aligned A. Law 3 and deviations do not concern it, C is exact. Its corners relative to t_B,
// each rounded once, are below 1.0001 S_B + 2 S_A; their mean T is off by 4.1 u S in all, its half
// extents by u S_A: within 7.01 u S.

namespace graze::narrowphase {

// Coefficients of dev_A S_A, dev_A S_B, dev_B S_B, S_A, S_B: those above, rounded up by more than
// what the computation of the slack rounds off.
inline constexpr double kDeviationOfA = 2;
inline constexpr double kDeviationOfAOnB = 10;
inline constexpr double kDeviationOfB = 6;
inline constexpr double kRoundingOfA = 0x20p-53;
inline constexpr double kRoundingOfB = 0x80p-53;
inline constexpr double kObbUnderflow = 0x1p-1068;
inline constexpr double kLargestObbSum = 0x1p1000;

}  // namespace graze::narrowphase

#pragma once

// How far the float arithmetic of wide trees can be off. Private to bvh/wide. u = 2^-24, the unit
// roundoff of float; |.| of a vector is its length where nothing else is said.
//
// Fitting. A node's axes f_i are unit vectors at right angles but for rounding: |f_i . f_j - [i =
// j]| < 2 u. A corner p is known to u |p|; its coordinate f_i . (p - o) is computed with an error
// of less than 4 u |p - o|; centre and half extent add 2 u. A box stands for the points o + sum s_i
// f_i, although what was bounded is f_i . (p - o): exchanging the dual basis for the f_i themselves
// costs 6 u |p - o|. All of it is below 22 u of S, the sum of the sizes of o, the centre and the
// half extents, and kFitError S is added to each half extent.
//
// Comparing. Coordinates are those along the host node's axes, y = F (p - o), in which a host's box
// is a box exactly and every vector is a direction to look along: no axis has to be a unit vector
// at right angles to others but the guest's, and their deviation from that is part of the query's
// slack (tripled, as for obb_separation.cpp). The guest's axes there, M_k = F R g_k, are off by 4 u
// in each component after the rotation, which rounding R to float begins, and by 10 u in the end.
// The way between the middles is off by 4 u (|c| + W) + u W, where c is the host box's centre and
// W, for boxes that do meet, at most the sum of both half diagonals. Along a cross product, the
// worst of the axes, the distance is off by 6 u |c| + 24 u W and the reach by 17 u W. All that a
// host slot's children hold lies in the slot's box: with its half diagonal D, |c| <= 2.74 D and a
// child's half diagonal is at most 1.74 D. In all less than 88 u D + 51 u times the guest's half
// diagonal; a half diagonal is at most the sum of the half extents.
//
// Eight guests that share a node. Their middles are M c + t, t the way between the nodes' origins,
// c a box's centre in its node, |c| <= 2.74 E for the half diagonal E of the slot that holds them
// all. M c is off by 10 u |c|_1 in each component for M's sake and rounds by 4 u |c|: 38 u |c| in
// all. t is longer than the way between middles by |c| at most, which is 4 u |c| more, and the sum
// rounds by u (|c'| + W), c' the host box's centre. With 52 u of the guest's half diagonal, which
// is at most 1.74 E, that is less than 210 u E: twice kComparisonError covers it.
//
// Leaves. A corner of a guest in the host's treelet, turned (5 u |p|, |p| <= 1.74 reach), scaled
// and moved by an offset (2 u of it, and u of the turned corner), is off by less than 11 u reach +
// 2 u offset; a corner of the host by u reach. Differences of two corners of the guest are off by
// twice as much. With delta for the error of a difference, slack included, and no component of any
// difference above L, the determinant of three differences is off by 18 L^2 (delta + u L) in first
// order, and its evaluation by 30 u L^3. Where delta is above 0.19 L nothing can be sure, for no
// determinant exceeds 6 L^3; below, higher orders add 3.6 L^2 delta.
//
// Distances. A gap along an axis is computed as the excess over a reach that has the margins above,
// which cover what grows with the boxes; what grows with the gap itself is below 25 u of it, for
// the way is at most the reaches and the gap. Axes are unit vectors at right angles but for 20 u,
// squares and sums of three of them round by 5 u, the division by a normal's square by 10 u.
// Squared bounds are too large by less than 2^-15 of themselves.

namespace graze::bvh {

inline constexpr float kFitError = 0x1p-19f;
inline constexpr float kComparisonError = 0x1p-17f;
inline constexpr float kCornerError = 0x1p-19f;
inline constexpr float kPlaneError = 32;
inline constexpr float kPlaneRounding = 0x1p-18f;
/// Products of three differences up to it cannot overflow.
inline constexpr float kLargestPlaneExtent = 0x1p40f;

/// A guest's unit in a host's beyond which sums of coordinates could overflow and still belong to
/// what meets: nothing is proved of such guests.
inline constexpr double kLargestScale = 0x1p60;

inline constexpr double kBoundGrowth = 1 + 0x1p-15;

/// Covers what underflows, where it is added to sums of products of at most three.
inline constexpr float kWideUnderflow = 0x1p-120f;

}  // namespace graze::bvh

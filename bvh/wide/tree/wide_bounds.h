#pragma once

// How far the float arithmetic of wide trees can be off. Private to bvh/wide. u = 2^-24, the unit
// roundoff of float; |.| of a vector is its length where nothing else is said. tests/proofs/wide_*
// proves these bounds from the constants, and names what is left to argue.
//
// Fitting. A node's axes f_i are unit vectors at right angles but for rounding: |f_i . f_j - [i =
// j]| < 2.01 u. A corner p is known to u |p|; its coordinate f_i . (p - o) is computed with an
// error of less than 4 u |p - o|; the half extent adds u. A box stands for the points o + sum s_i
// f_i, although what was bounded is f_i . (p - o): the dual basis in place of the f_i themselves
// changes a coordinate by 2.01 u times the sum of all |s_j|. All of it is below 8.1 u of S, the sum
// of the sizes of o, the centre and the half extents, and kFitError S is added to each half extent.
//
// Comparing. Coordinates are those along the tested node's axes, y = F (p - o), in which a tested
// node's box is a box exactly and every vector is a direction to look along: no axis has to be a
// unit vector at right angles to others but the query box's, and the deviation of the rotation
// between the trees is part of the query's slack (tripled, as for obb_separation.cpp). The query
// box's axes there, M_k = F R g_k, are off by 4 u in each component after the rotation, which
// rounding R to float begins, and by 10 u in the end; from unit vectors at right angles by 5.5 u,
// their cross products from the third axis by 10.5 u in each component. The offset between the
// middles is off by 4 u (|c| + W) + u W, where c is the tested node box's centre and W, for boxes
// that do meet, at most the sum of both half diagonals. Along a cross product, the worst of the
// axes, the distance is off by 6 u |c| + 24 u W, the radius by 10 u for each half extent that it
// takes, 10.5 u more for a query box's, and its rounding.
//
// All that the children of a tested node hold lies in the node's own box, which its parent stores.
// Let D be the sum of that box's half extents, which is at least the half diagonal of what it holds
// plus three times the fit's margin there. An origin inside, and the middle of an interval of
// length 2 D at most along each of three axes, are |c| <= 2.74 D apart; a child's half extents are
// D at most each, although its own margin may be 1.74 times the parent's, and its half
// diagonal 1.74 D. In all less than 101 u D + 54 u times the sum of the query box's half extents.
// Tested nodes in the top of the tree have the origin of the coordinates in place of one inside,
// and half extents with 512 u more (treelet_build.cpp).
//
// Eight query boxes that share a node. Their middles are M c + t, t the offset between the nodes'
// origins, c a box's centre in its node, |c| <= 2.74 E for the half diagonal E of the box that
// holds them all. M c is off by 10 u |c|_1 in each component for M's sake and rounds by 4 u |c|: 38
// u |c| in all. t is longer than the offset between middles by |c| at most, which is 4 u |c| more,
// and the sum rounds by u (|c'| + W), c' the tested node box's centre. With 52 u of the query box's
// half diagonal, which is at most 1.74 E, that is less than 210 u E: twice kComparisonError covers
// it. The last sum is 8 u D more for the tested node, too: 109 u in all.
//
// Slabs. Along n = (a, b, 1), whose components add up to 2.969 at most, a component of the offset,
// off by the comparison's margin at most, counts for up to 2.969 margins. The query box's axes
// along n are off by 36 u, the rest of them beside its own slab by 3.5 u more, two slabs read from
// bytes by 10 u D and 25 u times the sum of the query box's half extents, and the sums round by 26
// u D and 37 u of those: less than one margin. kSlabMargins covers both.
//
// Leaves. A corner of a query box in the tested node's treelet, turned (5 u |p|, |p| <= 1.74 m,
// with m the largest coordinate of the treelet), scaled and moved by an offset (2 u of it, and u of
// the turned corner), is off by less than 11 u m + 2 u offset; a corner of the tested node by u
// times its own treelet's m. Differences of two corners of the query box are off by twice as much.
//
// Primitives of a leaf in a node. Beside the error of a corner in the tested node's treelet, which
// turned counts 1.74 times, the offset to the node's origin, the turn and heights along a normal
// round by 14 u of the sum that kCornerError multiplies, the box's height, radius and ends by 28 u
// of the largest coordinate of the tested node's treelet.
//
// Shared axes. Boxes of both trees along three axes at right angles, in common units and from a
// point near what is looked for. Let |o| be the size of the coordinate of a node's origin there,
// which is computed in double, S the sum of the sizes of a box's centre and half extents. The
// node's axes along a shared one, first factors rounded, are off by 4.01 u, which counts for centre
// and half extent alike; three products and three sums round by 6.01 u of |o| and S, rounding the
// origin by u |o|, both ends of the interval by u of them: in all less than 14 u (|o| + S). Corners
// of a leaf, from their treelet's origin: u for a corner, u for an axis and 3.01 u for the
// products, of 1.74 m, with m the treelet's largest coordinate; with the last two sums less than
// 14 u (|o| + m) as well.
//
// Casts. B moves along e in the frame of A, where axes across e are off by 16 u' in each component,
// u' = 2^-53: while two points meet, it has gone no further than they were apart, below 1.8 tau + 7
// in common units, tau as in relative_frame.cpp, and comes by less than 128 u' (tau + 16) along
// such an axis. That is what the slack begins with, and once more of it is added.
//
// Planes. Let delta be the error of a difference, slack included, and L what no component of any
// difference exceeds. Any vector n will do to look along, the normal n = e x f as computed, too:
// if n . (q - p) is above both n . e and n . f, q is apart from the primitive of corner p and edges
// e and f, by the excess over |n|. As computed, n . (q - p) rounds by 16 u L^3. n . e would be zero
// for the exact product, from which a component of n is off by 4 u L^2: 12 u L^3. Exact
// differences are off by delta + u L in each component from those computed, that is 6 L^2 (delta +
// u L) for each of the two. In all 12 L^2 delta + 40 u L^3.
//
// Distances. A gap along an axis is computed as the excess over a radius that has the margins
// above, which cover what grows with the boxes; what grows with the gap itself is below 5.1 u of it
// in each of the tested node's axes and 24 u in the query box's, for the offset is at most the
// radii and the gap: as a vector of three, 42 u. Axes lengthen by 5.3 u, squares and sums of three
// round by 5 u, and a plane's gap, divided by the root of a square, by 6 u. Squared bounds are too
// large by less than 101 u = 2^-17.3 of themselves.

namespace graze::bvh {

inline constexpr float kFitError = 0x1p-19f;
inline constexpr float kComparisonError = 0x1p-17f;
/// Of a leaf's error, along the axes of a node and normals.
inline constexpr float kLeafInNodeError = 8;
/// Of a comparison's margin, along a slab's normal, which is longer than 1.
inline constexpr float kSlabMargins = 4;
inline constexpr float kCornerError = 0x1p-19f;
/// Of edges and offsets of primitives that are beside each other: for the largest coordinate of
/// what is stored, and for the size of what is turned.
inline constexpr float kStoredError = 0x1p-22f;
inline constexpr float kLocalError = 0x1p-21f;
inline constexpr float kAlignedError = 0x1p-20f;
inline constexpr float kPlaneError = 32;
inline constexpr float kPlaneRounding = 0x1p-18f;
/// Products of three differences up to it cannot overflow.
inline constexpr float kLargestPlaneExtent = 0x1p40f;

/// A query box's unit in a tested node's beyond which sums of coordinates could overflow and still
/// belong to what meets: nothing is proved of such query boxes.
inline constexpr double kLargestScale = 0x1p60;

/// Limits of squared distances grow by this before lower bounds are compared with them: more than
/// what rounding makes such bounds too large by ("Distances" above).
inline constexpr double kBoundGrowth = 1 + 0x1p-15;

/// Covers what underflows, where it is added to sums of products of at most three.
inline constexpr float kWideUnderflow = 0x1p-120f;

}  // namespace graze::bvh

#pragma once

// This derives how far the float arithmetic of wide trees can be off, one constant after the other.
// It is private to bvh/wide. tests/proofs/wide_* prove these bounds from the constants and from the
// lines of code that compute, and name what is left to argue.
//
// Notation. u = 2^-24 is the unit roundoff of float. |v| is the length of a vector, |v|_1 the sum
// of the sizes of its components. Four words are kept apart (engine/glossary.md): an error is what
// a computed number is off by; a margin is what a stored box is widened by for its own errors; the
// padding is what a query box is widened by in one comparison; the slack of a query (law 5) is part
// of each padding, and covers where placed primitives are.

namespace graze::bvh {

/// The margin of a box: so much of S is added to each half extent, S the sum of the sizes of the
/// node's origin, the box's centre and its half extents.
///
/// Coordinates are off. A corner p is known to u |p|. Its coordinate f_i . (p - o) is computed with
/// an error of less than 4 u |p - o|. The half extent adds u.
///
/// Axes are off. The axes f_i are unit vectors at right angles but for rounding: each product f_i .
/// f_j is less than 2.01 u from what it should be, 1 or 0. A box stands for the points o + sum s_i
/// f_i, although what was bounded are the coordinates above: the s_i are those by the dual basis,
/// which differ from these by 2.01 u times the sum of all |s_j|.
///
/// All of this is below 8.1 u S.
inline constexpr float kFitError = 0x1p-19f;

/// The padding of a query box among the children of a tested node: so much of the sum of the half
/// extents of the query box and of the box around all those children, and the slack, tripled.
///
/// The frame. Coordinates are those along the tested node's axes, y = F (p - o). There a tested
/// node's box is a box exactly, and every vector is a direction to look along. No axis has to be a
/// unit vector, nor at right angles to others, but for those of the query box. By how much the
/// transform between the trees is no rotation is part of the slack. That is derived for boxes along
/// the axes of the trees, and tripled because the Gram matrix of the transform, seen from a box's
/// own axes, deviates from the identity by up to three times as much as seen from the tree's.
///
/// The query box's axes there, M_k = F R g_k, are off by 4 u in each component after the rotation,
/// which begins with rounding R to float, and by 10 u in the end. From unit vectors at right angles
/// they are off by 5.5 u, their cross products from the third axis by 10.5 u in each component.
///
/// The offset between the middles is off by 4 u (|c| + W) + u W. Here c is the centre of the tested
/// node's box, and W, for boxes that do meet, is at most the sum of both half diagonals.
///
/// A cross product is the worst of the axes. Along it the distance is off by 6 u |c| + 24 u W. The
/// radius is off by 10 u for each half extent that it takes, by 10.5 u more for one of the query
/// box's, and by its own rounding.
///
/// The box around the children. All that the children hold lies in the box that their parent
/// stores. Let D be the sum of its half extents: that is at least the half diagonal of what it
/// holds and three times the margin of the fit. An origin inside, and the middle of an interval of
/// length 2 D at most along each of three axes, are |c| <= 2.74 D apart. The half extents of a
/// child are D at most, although its margin may be 1.74 times its parent's, and its half diagonal
/// is 1.74 D.
///
/// In all this is less than 101 u D and 54 u of the query box's half extents. In the top of the
/// tree the origin is that of the coordinates instead of one inside, for which half extents have
/// 512 u more (treelet_build.cpp).
///
/// Eight query boxes that share a node have twice as much of their own part. Their middles are M c
/// + t: t is the offset between the nodes' origins, c a box's centre in its node, and |c| <= 2.74 E
/// for the half diagonal E of the box that holds all eight. M c is off by 10 u |c|_1 in each
/// component because M is, and rounds by 4 u |c|: 38 u |c|. As t is longer than the offset between
/// middles by |c| at most, it adds 4 u |c|, and the sum rounds by u (|c'| + W), with c' the centre
/// of the tested node's box. With 52 u of the query box's half diagonal, which is at most 1.74 E,
/// that is less than 210 u E; the last sum adds 8 u D for the tested node: 109 u.
inline constexpr float kComparisonError = 0x1p-17f;

/// The margin of two slabs, in paddings of the comparison of their boxes.
///
/// They are compared along n = (a, b, 1), whose components add up to 2.969 at most. A component of
/// the offset, off by the padding at most, so counts for up to 2.969 paddings. The query box's axes
/// along n are off by 36 u, and what is left of them beside its own slab by 3.5 u more. Two slabs
/// that are read from bytes are off by 10 u D and 25 u of the query box's half extents; the sums
/// round by 26 u D and 37 u of these. That is less than one padding more.
inline constexpr float kSlabMargins = 4;

/// The error of a corner of a leaf, turned into the treelet of the other: so much of the sum of
/// both treelets' largest coordinates and of the offset between their origins.
///
/// A corner p of the query box, |p| <= 1.74 m with m the largest coordinate of its treelet, is
/// turned (5 u |p|), scaled, and moved by the offset (2 u of it, and u of the turned corner): off
/// by less than 11 u m + 2 u offset. A corner of the tested node is off by u times its own
/// treelet's m. Differences of two corners of the query box are off by twice as much.
inline constexpr float kCornerError = 0x1p-19f;

/// The margin of a primitive of a leaf along the axes of a node and along its normal, in errors of
/// its corners.
///
/// A corner's error, turned to the node's axes, counts 1.74 times. The offset to the node's origin,
/// the turn and the heights along a normal round by 14 u of the sum that kCornerError multiplies;
/// the height, radius and ends of the box by 28 u of the largest coordinate of the tested node's
/// treelet.
inline constexpr float kLeafInNodeError = 8;

/// The errors of two primitives of two leaves in coordinates of their own (local_leaves-inl.h,
/// pair_batch-inl.h): each as two edges from its first corner, and the offset from the tested
/// primitive's first corner to the other's, all in the tested node's frame. kStoredError is a share
/// of the largest coordinate of what is stored, kLocalError one of the size of what is turned.
///
/// A corner of the query box, off by u |p| as it is stored, is off by 1.74 u g once it is turned,
/// where g is the largest coordinate of the query's treelet; a corner of the tested node by u h.
/// The offsets of both first corners from those of their leaves are differences of floats, no
/// longer than the leaves' sizes t and s, and the offset between these, of component o at most, is
/// computed in double and rounded once. With the roundings of the columns, of products and of sums
/// the offset between two primitives is off by u (1.74 g + h) + 6 u (o + s + t), an edge of the
/// query box by u (3.47 g + 5 t), one of the tested node by u (2 h + s). What doubles round is less
/// than a millionth of that. So 4 u and 8 u are enough.
inline constexpr float kStoredError = 0x1p-22f;
inline constexpr float kLocalError = 0x1p-21f;

/// The error of boxes and corners along three axes that both trees share, in common units and seen
/// from a point near what is looked for: so much of |o| + S, or of |o| + m for corners. Here |o| is
/// the size of the coordinate of a node's or treelet's origin, S the sum of the sizes of a box's
/// centre and half extents, m the treelet's largest coordinate.
///
/// The origin's coordinate is computed in double. The node's axes along a shared one, first factors
/// rounded, are off by 4.01 u, which counts for centre and half extent alike. Three products and
/// three sums round by 6.01 u of |o| and S, the origin by u |o|, both ends of the interval by u of
/// them: in all less than 14 u (|o| + S). Corners: u for the corner, u for an axis, and 3.01 u for
/// the products, of 1.74 m; with the last two sums this is less than 14 u (|o| + m).
///
/// Casts. B moves along e in the frame of A. Axes across e are off by 16 u' in each component, u' =
/// 2^-53. While two points meet, B has gone no further than they were apart, below 1.8 tau + 7 in
/// common units, tau as in relative_frame.cpp. Along such an axis it so comes by less than 128 u'
/// of tau + 16, which is what the slack begins with; once more of it is added.
inline constexpr float kAlignedError = 0x1p-20f;

/// The error of heights over the plane of a primitive: 12 L^2 delta + 40 u L^3 at most, for
/// kPlaneError L^2 delta + kPlaneRounding L^3. Here delta is the error of a difference of corners,
/// slack included, and no component of such a difference exceeds L.
///
/// Any vector n will do to look along, and so will the normal n = e x f as it is computed. Let r be
/// the difference of corners q and p. If n . r is above both n . e and n . f, then q is apart from
/// the primitive of corner p and edges e and f, by the excess over |n|. As computed n . r rounds by
/// 16 u L^3. For the exact product n . e would be zero; from that a component of n is off by 4 u
/// L^2, which makes 12 u L^3. Exact differences are off by delta + u L in each component from those
/// computed: 6 L^2 (delta + u L) for each of the two.
inline constexpr float kPlaneError = 32;
inline constexpr float kPlaneRounding = 0x1p-18f;

/// The largest extent of a plane: products of three differences up to it cannot overflow.
inline constexpr float kLargestPlaneExtent = 0x1p40f;

/// A query box's unit in a tested node's beyond which sums of coordinates could overflow and still
/// belong to what meets: nothing is proved of such query boxes.
inline constexpr double kLargestScale = 0x1p60;

/// Limits of squared distances grow by this before lower bounds are compared with them: by more
/// than what such bounds are too large by.
///
/// A gap along an axis is the excess over a radius that has the padding above, which covers what
/// grows with the boxes. What grows with the gap itself is below 5.1 u of it along each of the
/// tested node's axes and 24 u along the query box's, for the offset is at most the radii and the
/// gap: 42 u as a vector of three. Axes lengthen by 5.3 u, squares and sums of three round by 5 u,
/// and a plane's gap, divided by the root of a square, by 6 u. So squared bounds are too large by
/// less than 101 u = 2^-17.3 of themselves.
inline constexpr double kBoundGrowth = 1 + 0x1p-15;

/// This covers what underflows, where it is added to sums of products of at most three.
inline constexpr float kWideUnderflow = 0x1p-120f;

}  // namespace graze::bvh

#pragma once

// The separating axis test for two boxes: three axes of each and nine cross products (Gottschalk,
// Lin and Manocha, "OBBTree", 1996). Private to bvh and narrowphase.
//
// Two convex polyhedra are apart if and only if a face normal of either, or the cross product of an
// edge of each, separates them. Let d be the offset of the centres, r_ij the component along axis i
// of A of axis j of B, and a_i, b_j the half extents. Along an axis n the boxes are apart if the
// size of n . d exceeds the sum of their projected radii, a_i |n . e_i| and b_j |n . f_j|:
//   n = e_i        |d_i| > a_i + sum_j b_j |r_ij|
//   n = f_j        |sum_i d_i r_ij| > b_j + sum_i a_i |r_ij|
//   n = e_i x f_j  |d_i2 r_i1j - d_i1 r_i2j|
//                    > a_i1 |r_i2j| + a_i2 |r_i1j| + b_j1 |r_ij2| + b_j2 |r_ij1|
// with i1, i2 the axes after i, and j1, j2 those after j. The kernels of wide trees use the same
// inequalities in lanes (bvh/wide/lanes/near_lanes-inl.h,
// bvh/wide/front/wide_front_kernels.cpp).

#include <cmath>

namespace graze::bvh {

/// Two boxes in the frame of the first: axis j of B is column j of `rotation`, its centre lies at
/// `offset` from that of A.
struct BoxesInFrame {
  const double (&rotation)[3][3];  ///< row-major
  const double (&size)[3][3];      ///< the absolute values of the rotation
  const double (&offset)[3];
  const double (&half_a)[3];
  const double (&half_b)[3];
};

/// The two boxes seen along an axis L that need not be of length 1: `distance` is L . (centre of B
/// - centre of A), `radius` the sum of the boxes' projected radii, sum h_k |L . axis k| of each. L
/// has the two apart if |distance| > radius.
///
/// The 15 axes, e_i of A and column C_j of the rotation for B: L = e_i gives L . C_k = C_ik; L =
/// C_j gives L . C_k = 0 for k other than j, as far as C is a rotation; L = e_i x C_j gives L . v =
/// C_(i+1)j v_(i+2) - C_(i+2)j v_(i+1) for vectors v of A's frame, and L . C_k = -+C_il for l
/// neither j nor k. What C is off from a rotation is for the caller's slack.
///
/// These functions are the one scalar form of the test: are_boxes_apart() and the gaps of
/// box_separation.cpp are made of them. Kernels repeat them operation by operation, so that all
/// round alike; where other sums are kept it is said why. They are static, so that each source
/// compiles its own copy, whatever flags others have.
struct AxisProjection {
  double distance;
  double radius;
};

static inline AxisProjection along_axis_of_a(const BoxesInFrame& boxes, int i) {
  const double(&s)[3][3] = boxes.size;
  const double(&half_b)[3] = boxes.half_b;
  const double radius =
      boxes.half_a[i] + half_b[0] * s[i][0] + half_b[1] * s[i][1] + half_b[2] * s[i][2];
  return {boxes.offset[i], radius};
}

static inline AxisProjection along_axis_of_b(const BoxesInFrame& boxes, int j) {
  const double(&r)[3][3] = boxes.rotation;
  const double(&s)[3][3] = boxes.size;
  const double(&d)[3] = boxes.offset;
  const double(&half_a)[3] = boxes.half_a;
  const double distance = d[0] * r[0][j] + d[1] * r[1][j] + d[2] * r[2][j];
  const double radius =
      boxes.half_b[j] + half_a[0] * s[0][j] + half_a[1] * s[1][j] + half_a[2] * s[2][j];
  return {distance, radius};
}

static inline AxisProjection along_cross_product(const BoxesInFrame& boxes, int i, int j) {
  const double(&r)[3][3] = boxes.rotation;
  const double(&s)[3][3] = boxes.size;
  const double(&d)[3] = boxes.offset;
  const double(&half_a)[3] = boxes.half_a;
  const double(&half_b)[3] = boxes.half_b;
  const int i1 = (i + 1) % 3;
  const int i2 = (i + 2) % 3;
  const int j1 = (j + 1) % 3;
  const int j2 = (j + 2) % 3;
  const double distance = d[i2] * r[i1][j] - d[i1] * r[i2][j];
  const double radius =
      half_a[i1] * s[i2][j] + half_a[i2] * s[i1][j] + half_b[j1] * s[i][j2] + half_b[j2] * s[i][j1];
  return {distance, radius};
}

static inline bool is_separating(const AxisProjection& projection, double slack) {
  return std::abs(projection.distance) > projection.radius + slack;
}

/// True if an axis has the boxes further apart than `slack`, which must cover all rounding and the
/// rotation's deviation from one. A slack or an offset that is NaN or infinite proves nothing.
static inline bool are_boxes_apart(const BoxesInFrame& boxes, double slack) {
  for (int i = 0; i < 3; ++i) {
    if (is_separating(along_axis_of_a(boxes, i), slack)) return true;
  }
  for (int j = 0; j < 3; ++j) {
    if (is_separating(along_axis_of_b(boxes, j), slack)) return true;
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (is_separating(along_cross_product(boxes, i, j), slack)) return true;
    }
  }
  return false;
}

}  // namespace graze::bvh

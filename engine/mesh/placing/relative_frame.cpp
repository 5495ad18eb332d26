// The derivation of law 5's slack. u = 2^-53; |.| of a vector is its largest component. Write R, t
// for a pose, o for the centre and r for the radius (largest |x - o|) of a tree's frame, m for the
// mesh's largest coordinate, dev = max |R^T R - I| with the rounding of its measurement. Rows and
// columns of R have 1-norms below 1.74.
//
// Placement. Law 1 rounds each coordinate of R x + t six times: off by at most 4 u * 1.74 m + 2 u
// |t|, and underflow. The placed centre P = R o + t, computed alike, has |o| <= m. So with placing
// = 8 u (m + |t|), a placed vertex p has p - P = R (x - o) + e, |e| <= 2 placing.
//
// The common frame is y = R_A^T (p - P_A), for both meshes and whatever R_A is: where two placed
// triangles share a point p, they share y.
//   A: y = R_A^T R_A (x - o_A) + R_A^T e is off from x - o_A by 3 dev_A r_A + 3.5 placing_A.
//   B: y = C (x - o_B) + T with C = R_A^T R_B and T = R_A^T (P_B - P_A), off by 3.5 placing_B; C as
//      computed by 4 u an entry, 12 u r_B; T by 10 u |P_B - P_A|.
// An oriented box as B holds by law 3 the points whose rounded coordinates R_B^T (v - t_B) are
// within its half extents, r_B at most: these coordinates are off by 16 u r_B, and from the box's
// points in the frame by 3 dev_B r_B.
//
// Not quite rotations. The axes C_j of B are used as they are, but their products C_j . C_k are
// taken for those of unit vectors. R_A R_A^T differs from I by 3 dev_A at most (the spectral norm
// is that of R_A^T R_A - I), so C^T C by g = 3.01 dev_A + dev_B + 12 u an entry; C_j x C_k from C_l
// by 9 g. Over the extents of B's boxes that is at most 18 g r_B.
//
// The axes have 2-norms of about 1 and 1-norms below 1.74, so twice the errors of A and B cover
// them, whether an error's largest component is taken in y or, as for the oriented box, in B's
// frame. The rounding of the separating axis test itself, with |T| = tau in common units, in which
// boxes are at most 2 in size and 4 across, is below 128 u (tau + 16).

#include <graze/bvh/value/dot.h>
#include <graze/bvh/value/power_of_two.h>
#include <graze/engine/mesh/placing/relative_frame.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

constexpr double kUnitRoundoff = 0x1p-53;

double largest_component(const double* v) {
  return std::max(std::abs(v[0]), std::max(std::abs(v[1]), std::abs(v[2])));
}

using bvh::dot;

/// Sets all of the relative frame but its rotation.
inline void set_translation_and_slack(bvh::RelativeFrame& relative, const PlacedFrame& side_a,
                                      const PlacedFrame& side_b) {
  // These are common units: those of the larger frame. Scaling by powers of two is exact; what
  // underflows is covered by the last term of the slack.
  const int exponent = std::max(side_a.frame.exponent, side_b.frame.exponent);
  const double per_metre = bvh::power_of_two(-exponent);

  const double between[3] = {side_b.centre[0] - side_a.centre[0],
                             side_b.centre[1] - side_a.centre[1],
                             side_b.centre[2] - side_a.centre[2]};
  double tau = 0;
  for (int i = 0; i < 3; ++i) {
    relative.translation[i] = dot(side_a.m + 4 * i, between) * per_metre;
    tau = std::max(tau, std::abs(relative.translation[i]));
  }
  relative.units_a = bvh::power_of_two(side_a.frame.exponent - exponent);
  relative.units_b = bvh::power_of_two(side_b.frame.exponent - exponent);

  const double error_a = 3 * side_a.deviation * side_a.radius + 3.5 * side_a.placing;
  const double error_b = (3 * side_b.deviation + 28 * kUnitRoundoff) * side_b.radius +
                         3.5 * side_b.placing + 10 * kUnitRoundoff * largest_component(between);
  const double gram = 3.01 * side_a.deviation + side_b.deviation + 12 * kUnitRoundoff;
  const double metres = 2 * (error_a + error_b) + 18 * gram * side_b.radius;
  // A hundredth more covers the rounding of these lines.
  relative.slack = 1.01 * (metres * per_metre + 128 * kUnitRoundoff * (tau + 16)) + 0x1p-900;
}

}  // namespace

PlacedFrame::PlacedFrame(const Pose& pose, double pose_deviation, const bvh::LocalFrame& tree_frame,
                         const Aabb& bounds)
    : m(pose.data()),
      frame(tree_frame),
      deviation(pose_deviation + 8 * kUnitRoundoff),
      radius(2 * bvh::power_of_two(frame.exponent)),
      largest(std::max(largest_component(bounds.min.data()), largest_component(bounds.max.data()))),
      placing(8 * kUnitRoundoff * (largest + largest_component(m + 12)) + 0x1p-1070) {
  const double* o = frame.centre;
  for (int i = 0; i < 3; ++i) {
    centre[i] = ((m[i] * o[0] + m[4 + i] * o[1]) + m[8 + i] * o[2]) + m[12 + i];
  }
}

bvh::RelativeFrame relative_frame(const PlacedFrame& a, const PlacedFrame& b) {
  bvh::RelativeFrame relative;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      relative.rotation[i][j] = dot(a.m + 4 * i, b.m + 4 * j);
  }
  set_translation_and_slack(relative, a, b);
  return relative;
}

bvh::RelativeFrame reversed(const bvh::RelativeFrame& b_in_a, const PlacedFrame& a,
                            const PlacedFrame& b) {
  bvh::RelativeFrame relative;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      relative.rotation[i][j] = b_in_a.rotation[j][i];
  }
  set_translation_and_slack(relative, b, a);
  return relative;
}

}  // namespace graze

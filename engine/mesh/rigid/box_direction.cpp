// This finds the axis along which two boxes are furthest apart, among those of the separating axis
// test, each divided by its length, with the sums of bvh/value/separating_axes.h for two axes of B
// at a time. What comes out is only a direction to try, so that rounding needs no bound here.

#include <graze/engine/mesh/rigid/box_direction.h>

#include <cmath>

namespace graze {
namespace {

using narrowphase::are_greater, narrowphase::both, narrowphase::both_of, narrowphase::magnitude,
    narrowphase::sign_bits;

// Edges that are nearer to parallel than that have no cross product worth trying. This is the
// squared sine.
constexpr double kLeastSquare = 0x1p-10;

/// Takes an axis of a box into the common frame.
void place_axis(const Pose& pose, const double (&axis)[3], double (&placed)[3]) {
  const double* m = pose.data();
  for (int i = 0; i < 3; ++i)
    placed[i] = (m[i] * axis[0] + m[4 + i] * axis[1]) + m[8 + i] * axis[2];
}

}  // namespace

AxisSearch::AxisSearch(const PlacedBodies& placed, const BodyBox& a, const BodyBox& b, double limit)
    : placed_(placed), box_a_(a), box_b_(b), gap_(limit) {
  double between[3];  // the offset of the centres in the frame of body A
  for (int i = 0; i < 3; ++i) {
    between[i] = (dot_product(placed.pose_a.data() + 4 * i, placed.between) +
                  dot_product(placed.rotation[i], b.centre)) -
                 a.centre[i];
  }
  for (int i = 0; i < 3; ++i) {
    offset_[i] = dot_product(a.axes[i], between);
    holds_centre_ = holds_centre_ && std::abs(offset_[i]) <= a.half[i];
  }
}

bool AxisSearch::try_faces(ApartDirection& direction) {
  if (holds_centre_) return false;
  const double(&half_a)[3] = box_a_.half;
  const double(&half_b)[3] = box_b_.half;
  AlongB axes[3], turned[3];  // a component each, in the frames of the bodies B and A
  for (int k = 0; k < 3; ++k) {
    axes[k].at[0] = TwoLanes{box_b_.axes[0][k], box_b_.axes[1][k]};
    axes[k].at[1] = TwoLanes{box_b_.axes[2][k], 0};
  }
  const auto combined = [](const double(&row)[3], const AlongB(&of)[3], AlongB& to) {
    for (int h = 0; h < 2; ++h)
      to.at[h] =
          (both(row[0]) * of[0].at[h] + both(row[1]) * of[1].at[h]) + both(row[2]) * of[2].at[h];
  };
  for (int i = 0; i < 3; ++i)
    combined(placed_.rotation[i], axes, turned[i]);
  for (int i = 0; i < 3; ++i) {
    combined(box_a_.axes[i], turned, rotation_[i]);
    for (int h = 0; h < 2; ++h)
      size_[i].at[h] = magnitude(rotation_[i].at[h]);
    const AlongB& s = size_[i];
    const double radius = ((half_a[i] + half_b[0] * s[0]) + half_b[1] * s[1]) + half_b[2] * s[2];
    take(offset_[i], radius, 1, i, -1);
  }
  for (int h = 0; h < 2; ++h) {
    const TwoLanes distance =
        (both(offset_[0]) * rotation_[0].at[h] + both(offset_[1]) * rotation_[1].at[h]) +
        both(offset_[2]) * rotation_[2].at[h];
    const TwoLanes half = h == 0 ? TwoLanes{half_b[0], half_b[1]} : TwoLanes{half_b[2], 0};
    const TwoLanes radius =
        ((half + both(half_a[0]) * size_[0].at[h]) + both(half_a[1]) * size_[1].at[h]) +
        both(half_a[2]) * size_[2].at[h];
    take(distance[0], radius[0], 1, -1, 2 * h);
    if (h == 0) take(distance[1], radius[1], 1, -1, 1);
  }
  if (i_ < 0 && j_ < 0) return false;
  set_direction(direction);
  return true;
}

/// Tries the cross products of one axis of A with all three of B.
template <int I>
void AxisSearch::try_edges_of() {
  constexpr int kOne = (I + 1) % 3, kTwo = (I + 2) % 3;
  const double(&half_a)[3] = box_a_.half;
  const double(&half_b)[3] = box_b_.half;
  const AlongB &s = size_[I], &r = rotation_[I];
  // An axis of B adds what the two others of B extend along the cross product.
  const TwoLanes one[2] = {TwoLanes{half_b[1], half_b[2]} * TwoLanes{s[2], s[0]},
                           TwoLanes{half_b[0] * s[1], 0}};
  const TwoLanes two[2] = {TwoLanes{half_b[2], half_b[0]} * TwoLanes{s[1], s[2]},
                           TwoLanes{half_b[1] * s[0], 0}};
  for (int h = 0; h < 2; ++h) {
    const TwoLanes distance =
        both(offset_[kTwo]) * rotation_[kOne].at[h] - both(offset_[kOne]) * rotation_[kTwo].at[h];
    const TwoLanes radius =
        ((both(half_a[kOne]) * size_[kTwo].at[h] + both(half_a[kTwo]) * size_[kOne].at[h]) +
         one[h]) +
        two[h];
    const TwoLanes square = both(1) - r.at[h] * r.at[h];
    const TwoLanes apart = magnitude(distance) - radius;
    const TwoLanes is_better = both_of(are_greater(apart, both(0)),
                                       are_greater(apart * apart, both(gap_ * gap_) * square));
    const unsigned better = sign_bits(both_of(is_better, are_greater(square, both(kLeastSquare))));
    if (better == 0) continue;  // as is mostly so
    if ((better & 1) != 0) take(distance[0], radius[0], square[0], I, 2 * h);
    if ((better & 2) != 0) take(distance[1], radius[1], square[1], I, 2 * h + 1);
  }
}

bool AxisSearch::try_edges(ApartDirection& direction) {
  if (holds_centre_) return false;
  const double before = gap_;
  try_edges_of<0>();
  try_edges_of<1>();
  try_edges_of<2>();
  if (!(gap_ > before)) return false;
  set_direction(direction);
  return true;
}

/// Takes the axis if it is better; its length is the root of `square`, which few need.
void AxisSearch::take(double distance, double radius, double square, int of_a, int of_b) {
  const double apart = std::abs(distance) - radius;
  if (!(apart > 0) || !(apart * apart > gap_ * gap_ * square)) return;
  gap_ = apart / std::sqrt(square);
  along_ = distance;
  i_ = of_a;
  j_ = of_b;
}

/// Returns the axis in the common frame, from A to B.
void AxisSearch::set_direction(ApartDirection& direction) const {
  double a[3], b[3];
  if (i_ >= 0) place_axis(placed_.pose_a, box_a_.axes[i_], a);
  if (j_ >= 0) place_axis(placed_.pose_b, box_b_.axes[j_], b);
  double(&n)[3] = direction.n;
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    n[k] = j_ < 0 ? a[k] : i_ < 0 ? b[k] : a[l] * b[m] - a[m] * b[l];
  }
  const double scale = (along_ < 0 ? -1 : 1) / std::sqrt(dot_product(n, n));
  for (double& x : n)
    x *= scale;
}

}  // namespace graze

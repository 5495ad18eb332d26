// Along which axis two boxes are furthest apart: those of the separating axis test, each divided by
// its length. What comes out is only a direction to try, so that rounding needs no bound here.

#include <graze/bvh/value/separating_axes.h>
#include <graze/engine/mesh/rigid/box_direction.h>

#include <cmath>

namespace graze {
namespace {

// Edges that are nearer to parallel have no cross product worth trying: squared sine.
constexpr double kLeastSquare = 0x1p-10;

/// An axis of a box in the common frame.
void place_axis(const Pose& pose, const double (&axis)[3], double (&placed)[3]) {
  const double* m = pose.data();
  for (int i = 0; i < 3; ++i)
    placed[i] = (m[i] * axis[0] + m[4 + i] * axis[1]) + m[8 + i] * axis[2];
}

}  // namespace

AxisSearch::AxisSearch(const PlacedBodies& placed, const BodyBox& a, const BodyBox& b, double limit)
    : placed_(placed), box_a_(a), box_b_(b), gap_(limit) {
  double between[3];  // in the frame of body A
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
  double turned[3][3];  // [axis of b][component]
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      turned[j][i] = dot_product(placed_.rotation[i], box_b_.axes[j]);
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      rotation_[i][j] = dot_product(box_a_.axes[i], turned[j]);
      size_[i][j] = std::abs(rotation_[i][j]);
    }
  }
  const bvh::BoxesInFrame boxes{rotation_, size_, offset_, box_a_.half, box_b_.half};
  for (int i = 0; i < 3; ++i) {
    const bvh::AxisProjection of_a = bvh::along_axis_of_a(boxes, i);
    take(of_a.distance, of_a.radius, 1, i, -1);
    const bvh::AxisProjection of_b = bvh::along_axis_of_b(boxes, i);
    take(of_b.distance, of_b.radius, 1, -1, i);
  }
  if (i_ < 0 && j_ < 0) return false;
  set_direction(direction);
  return true;
}

bool AxisSearch::try_edges(ApartDirection& direction) {
  if (holds_centre_) return false;
  const double before = gap_;
  const bvh::BoxesInFrame boxes{rotation_, size_, offset_, box_a_.half, box_b_.half};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double square = 1 - rotation_[i][j] * rotation_[i][j];
      if (!(square > kLeastSquare)) continue;
      const bvh::AxisProjection seen = bvh::along_cross_product(boxes, i, j);
      take(seen.distance, seen.radius, square, i, j);
    }
  }
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

/// The axis in the common frame, from A to B.
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

// Along which axis two boxes are furthest apart: those of the separating axis test, each divided by
// its length. What comes out is only a direction to try, so that rounding needs no bound here.

#include <graze/bvh/value/separating_axes.h>
#include <graze/engine/mesh/rigid/box_direction.h>

#include <cmath>

namespace graze {
namespace {

// Edges that are nearer to parallel have no cross product worth trying: squared sine.
constexpr double kLeastSquare = 0x1p-10;

/// The axis that is best so far.
struct BestAxis {
  double gap;
  double along;  ///< of the centres
  int i = -1;    ///< 0 to 2 of A, -1 for none
  int j = -1;    ///< of B

  void take(const bvh::AxisProjection& seen, double scale, int of_a, int of_b) {
    const double apart = (std::abs(seen.distance) - seen.radius) * scale;
    if (!(apart > gap)) return;
    gap = apart;
    along = seen.distance;
    i = of_a;
    j = of_b;
  }
};

double dot(const double* a, const double* b) {
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

/// Both boxes along the axes of the first.
struct BoxesAlongA {
  double rotation[3][3];
  double size[3][3];
  double offset[3];

  BoxesAlongA(const PlacedBodies& placed, const BodyBox& a, const BodyBox& b) {
    double between[3], turned[3][3];  // in the frame of body A; [axis of b][component]
    for (int i = 0; i < 3; ++i) {
      const double(&row)[3] = placed.rotation[i];
      between[i] =
          (dot(placed.pose_a.data() + 4 * i, placed.between) + dot(row, b.centre)) - a.centre[i];
      for (int j = 0; j < 3; ++j)
        turned[j][i] = dot(row, b.axes[j]);
    }
    for (int i = 0; i < 3; ++i) {
      offset[i] = dot(a.axes[i], between);
      for (int j = 0; j < 3; ++j) {
        rotation[i][j] = dot(a.axes[i], turned[j]);
        size[i][j] = std::abs(rotation[i][j]);
      }
    }
  }
};

/// An axis of a box in the common frame.
void place_axis(const Pose& pose, const double (&axis)[3], double (&placed)[3]) {
  const double* m = pose.data();
  for (int i = 0; i < 3; ++i)
    placed[i] = (m[i] * axis[0] + m[4 + i] * axis[1]) + m[8 + i] * axis[2];
}

/// The axis in the common frame, from A to B.
void set_direction(const PlacedBodies& placed, const BodyBox& box_a, const BodyBox& box_b,
                   const BestAxis& best, ApartDirection& direction) {
  double a[3], b[3];
  if (best.i >= 0) place_axis(placed.pose_a, box_a.axes[best.i], a);
  if (best.j >= 0) place_axis(placed.pose_b, box_b.axes[best.j], b);
  double(&n)[3] = direction.n;
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    n[k] = best.j < 0 ? a[k] : best.i < 0 ? b[k] : a[l] * b[m] - a[m] * b[l];
  }
  const double scale = (best.along < 0 ? -1 : 1) / std::sqrt(dot(n, n));
  for (double& x : n)
    x *= scale;
}

}  // namespace

bool find_direction(const PlacedBodies& placed, const BodyBox& a, const BodyBox& b, double limit,
                    ApartDirection& direction) {
  const BoxesAlongA along(placed, a, b);
  const bvh::BoxesInFrame boxes{along.rotation, along.size, along.offset, a.half, b.half};
  BestAxis best{.gap = limit, .along = 0};
  for (int i = 0; i < 3; ++i) {
    best.take(bvh::along_axis_of_a(boxes, i), 1, i, -1);
    best.take(bvh::along_axis_of_b(boxes, i), 1, -1, i);
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double square = 1 - along.rotation[i][j] * along.rotation[i][j];
      if (square > kLeastSquare)
        best.take(bvh::along_cross_product(boxes, i, j), 1 / std::sqrt(square), i, j);
    }
  }
  if (best.i < 0 && best.j < 0) return false;
  set_direction(placed, a, b, best, direction);
  return true;
}

}  // namespace graze

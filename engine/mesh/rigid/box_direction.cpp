// Along which axis two boxes are furthest apart: those of the separating axis test, each divided by
// its length. What comes out is only a direction to try, so that rounding needs no bound here.

#include <graze/bvh/value/separating_axes.h>
#include <graze/engine/mesh/rigid/moving_pair.h>

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

bool normalise(double (&n)[3]) {
  const double square = (n[0] * n[0] + n[1] * n[1]) + n[2] * n[2];
  if (!(square > 0x1p-100)) return false;
  const double scale = 1 / std::sqrt(square);
  for (double& x : n)
    x *= scale;
  return true;
}

/// The axis in the common frame, from A to B.
bool direction_of(const PlacedBodies& placed, const BestAxis& best, ApartDirection& direction) {
  const double* a = placed.pose_a.data() + 4 * (best.i < 0 ? 0 : best.i);
  const double* b = placed.pose_b.data() + 4 * (best.j < 0 ? 0 : best.j);
  const double sign = best.along < 0 ? -1 : 1;
  double(&n)[3] = direction.n;
  if (best.i < 0 || best.j < 0) {
    const double* axis = best.i < 0 ? b : a;
    for (int k = 0; k < 3; ++k)
      n[k] = sign * axis[k];
  } else {
    n[0] = sign * (a[1] * b[2] - a[2] * b[1]);
    n[1] = sign * (a[2] * b[0] - a[0] * b[2]);
    n[2] = sign * (a[0] * b[1] - a[1] * b[0]);
  }
  return normalise(n);
}

}  // namespace

bool MovingPair::find_direction(std::uint64_t time, const MetricBox& box_a, const MetricBox& box_b,
                                ApartDirection& direction) {
  const PlacedBodies& placed = related(time);
  double offset[3];
  for (int i = 0; i < 3; ++i) {
    const double(&row)[3] = placed.rotation[i];
    offset[i] = (placed.offset_in_a[i] - box_a.centre[i]) +
                ((row[0] * box_b.centre[0] + row[1] * box_b.centre[1]) + row[2] * box_b.centre[2]);
  }
  const bvh::BoxesInFrame boxes{placed.rotation, placed.size, offset, box_a.half, box_b.half};
  BestAxis best{.gap = limit_, .along = 0};
  for (int i = 0; i < 3; ++i) {
    best.take(bvh::along_axis_of_a(boxes, i), 1, i, -1);
    best.take(bvh::along_axis_of_b(boxes, i), 1, -1, i);
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double square = 1 - placed.rotation[i][j] * placed.rotation[i][j];
      if (square > kLeastSquare)
        best.take(bvh::along_cross_product(boxes, i, j), 1 / std::sqrt(square), i, j);
    }
  }
  return (best.i >= 0 || best.j >= 0) && direction_of(placed, best, direction);
}

}  // namespace graze

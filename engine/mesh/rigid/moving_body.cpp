// What is computed of a placed vertex, with u = 2^-53 and S the sum of the sizes of the mesh's
// bounds and of the lengths of its motion:
//   - entries of Q - 1 are off by 24 u: 4 u for sines and versines, 4 u for products, and an axis
//   is
//     of length 1 but for 3 u, which counts twice, for entries of at most 2. Those of Q R by 80 u,
//     and so a vertex by 80 u S, and as much by the translation;
//   - law 1 rounds 8 u S, a gap of boxes along a direction 20 u S, a distance (law 7) 16 u S.
// Added up and along a direction, of 1-norm 1.74 at most, that is less than 400 u S of 1024 u S.
// The product of t and the angle is off by u of it, which turns the body: less than 2^-53 turned
// radius, of 2^-51.

#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/placing/placement_check.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/mesh/rigid/moving_body.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

// The start of a motion is a rotation up to 1e-6, and a root and products are rounded a few times.
constexpr double kStretch = 1 + 0x1p-18;

// What is lost where squares underflow.
constexpr double kLeast = 0x1p-500;

/// How far the point of the body is from the axis, but for rounding.
double distance_from_axis(const RigidMotion& motion, const Eigen::Vector3d& point) {
  const Eigen::Vector3d placed = narrowphase::place(motion.start(), point);
  const double* p = placed.data();
  const double* c = motion.centre().data();
  const double* a = motion.axis().data();
  const double q[3] = {p[0] - c[0], p[1] - c[1], p[2] - c[2]};
  const double x = q[1] * a[2] - q[2] * a[1];
  const double y = q[2] * a[0] - q[0] * a[2];
  const double z = q[0] * a[1] - q[1] * a[0];
  return std::sqrt((x * x + y * y) + z * z);
}

}  // namespace

MovingBody::MovingBody(const Mesh& of_mesh, const RigidMotion& in_motion, const char* what,
                       Work& work)
    : mesh(of_mesh),
      motion(in_motion),
      tree((check_reach(in_motion, of_mesh.bounds(), what), tree_of(of_mesh, &work))),
      unit(tree.frame.unit()),
      turned(std::abs(in_motion.angle())),
      radius(0),
      rounding(0x1p-43 * (sum_of_sizes(of_mesh.bounds()) + sum_of_lengths(in_motion))) {
  const Aabb& bounds = mesh.bounds();
  MetricBox around;
  for (int i = 0; i < 3; ++i) {
    const double min = bounds.min.data()[i], max = bounds.max.data()[i];
    around.centre[i] = (min / 2 + max / 2) - tree.frame.centre[i];
    around.half[i] = max / 2 - min / 2;
  }
  radius = radius_of(around);
  rounding += 0x1p-51 * turned * radius;
}

double MovingBody::radius_of(const MetricBox& box) const {
  if (turned == 0) return 0;
  const double(&h)[3] = box.half;
  const double* o = tree.frame.centre;
  const double away = distance_from_axis(
      motion, {o[0] + box.centre[0], o[1] + box.centre[1], o[2] + box.centre[2]});
  const double reach = std::sqrt((h[0] * h[0] + h[1] * h[1]) + h[2] * h[2]);
  return (away + reach) * kStretch + rounding + kLeast;
}

double MovingBody::radius_of(const Triangle& triangle) const {
  if (turned == 0) return 0;
  const double away = std::max(
      distance_from_axis(motion, triangle.a),
      std::max(distance_from_axis(motion, triangle.b), distance_from_axis(motion, triangle.c)));
  return away * kStretch + rounding + kLeast;
}

}  // namespace graze

// This bounds how far what is computed of a placed vertex is off, with u = 2^-53 and S the sum of
// the sizes of the mesh's bounds and of the lengths of its motion:
//   - entries of Q - 1 are off by 44 u: 8 u for versines and for sines, 4 u for products, and an
//     axis is of length 1 but for 6 u, which counts twice, for entries of at most 2. Those of Q R
//     are off by 84 u, and so is a vertex by 84 u S, and as much by the translation;
//   - law 1 rounds 8 u S, a gap of boxes along a direction 20 u S, a distance (law 7) 16 u S.
// Added up and along a direction, of 1-norm 1.74 at most, that is less than 400 u S of 1024 u S.
// The product of t and the angle is off by u of it, which turns the body: less than 2^-53 turned
// radius, of 2^-51.

#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/placing/placement_check.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/mesh/rigid/moving_body.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

// Lengths may grow by this factor: the start of a motion is a rotation up to 1e-6, and a root and
// products are rounded a few times.
constexpr double kStretch = 1 + 0x1p-18;

// This covers what is lost where squares underflow.
constexpr double kLeast = 0x1p-500;

double length_of(const double (&v)[3]) {
  return std::sqrt((v[0] * v[0] + v[1] * v[1]) + v[2] * v[2]);
}

}  // namespace

MovingBody::MovingBody(const Mesh& of_mesh, const RigidMotion& in_motion, const char* what,
                       Work& work)
    : mesh(of_mesh),
      motion(in_motion),
      tree((check_coordinates(in_motion, of_mesh.bounds(), what), tree_of(of_mesh, &work))),
      boxes(obb_skin_of(of_mesh, &work)),
      unit(tree.frame.unit()),
      turned(std::abs(in_motion.angle())),
      radius(0),
      rounding(0x1p-43 * (sum_of_sizes(of_mesh.bounds()) + sum_of_lengths(in_motion))) {
  if (turned == 0) return;
  const Aabb& bounds = mesh.bounds();
  double centre[3], half[3];
  for (int i = 0; i < 3; ++i) {
    const double min = bounds.min.data()[i], max = bounds.max.data()[i];
    centre[i] = min / 2 + max / 2;
    half[i] = max / 2 - min / 2;
  }
  radius = with_rounding(distance_from_axis(centre) + length_of(half));
  rounding += 0x1p-51 * turned * radius;
}

double MovingBody::distance_from_axis(const double* point) const {
  const Eigen::Vector3d placed = narrowphase::place(motion.start(), {point[0], point[1], point[2]});
  const double* p = placed.data();
  const double* c = motion.centre().data();
  const double* a = motion.axis().data();
  const double q[3] = {p[0] - c[0], p[1] - c[1], p[2] - c[2]};
  const double across[3] = {q[1] * a[2] - q[2] * a[1], q[2] * a[0] - q[0] * a[2],
                            q[0] * a[1] - q[1] * a[0]};
  return length_of(across);
}

double MovingBody::with_rounding(double of_radius) const {
  return of_radius * kStretch + rounding + kLeast;
}

BodyBox MovingBody::box(std::uint32_t node) const {
  const bvh::FloatObb& from = boxes[node];
  BodyBox box;
  for (int i = 0; i < 3; ++i) {
    box.centre[i] = tree.frame.centre[i] + static_cast<double>(from.centre[i]) * unit;
    box.half[i] = static_cast<double>(from.half[i]) * unit;
    for (int k = 0; k < 3; ++k)
      box.axes[i][k] = static_cast<double>(from.axes[i][k]);
  }
  // The axes are known up to kAxisError in each component, of a direction whose 1-norm is at most
  // 1.74.
  box.axes_error = 2 * bvh::FloatObb::kAxisError * (box.half[0] + box.half[1] + box.half[2]);
  box.radius =
      turned == 0 ? 0 : with_rounding(distance_from_axis(box.centre) + length_of(box.half));
  return box;
}

BodyTriangle MovingBody::triangle(std::uint32_t index) const {
  const std::span<const Eigen::Vector3d> vertices = mesh.vertices();
  const TriangleIndices& t = mesh.triangles()[index];
  BodyTriangle triangle;
  double away = 0;
  for (int i = 0; i < 3; ++i) {
    const double* p = vertices[t[i]].data();
    for (int k = 0; k < 3; ++k)
      triangle.corners[i][k] = p[k];
    if (turned != 0) away = std::max(away, distance_from_axis(p));
  }
  triangle.radius = turned == 0 ? 0 : with_rounding(away);
  return triangle;
}

}  // namespace graze

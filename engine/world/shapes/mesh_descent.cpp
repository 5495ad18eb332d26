#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/world/shapes/mesh_descent.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <cmath>

namespace graze {

using narrowphase::Core;
using narrowphase::Vec3;

namespace {

// A length in a tree's units, of which its boxes measure a few: anything that far away is beside
// all boxes, and no float overflows.
constexpr double kFar = 0x1p60;

struct Extent {
  double low, high;
};

/// Returns the extent of the set along a column of a rotation, for balls and boxes without a
/// support point.
Extent extent_along(const Core& core, const Vec3& axis) {
  using enum narrowphase::CoreKind;
  if (core.kind != Point && core.kind != Box)
    return {dot(rounded_support(core, -axis), axis), dot(rounded_support(core, axis), axis)};
  const double middle = dot(core.at, axis);
  const double projected_radius = (std::abs(dot(core.axis[0], axis)) * core.half.x +
                                   std::abs(dot(core.axis[1], axis)) * core.half.y) +
                                  (std::abs(dot(core.axis[2], axis)) * core.half.z + core.radius);
  return {middle - projected_radius, middle + projected_radius};
}

}  // namespace

// A point p of a placed triangle, p = R x + t to rounding, has the coordinates q = R^T (p - t) in
// the mesh's frame: off from x by R^T R - I, 3 dev of the largest coordinate of x, and by law 1's
// rounding, 8 u of all coordinates in between. The set's box there comes from its extent along
// R's columns, off by 20 u of the pair's scale, and by 2 dev of the radius for columns that are not
// quite of length 1. The slack, 8 dev + 2^-45 of the sum of all, covers both.
MeshDescent::MeshDescent(const PlacedMeshView& mesh, const Core& core,
                         const Eigen::Vector3d& origin, Work& work)
    : mesh_(mesh),
      origin_(origin),
      tree_(tree_of(mesh.mesh, &work)),
      vertices_(mesh.mesh.vertices()),
      triangles_(mesh.mesh.triangles()),
      work_(work) {
  const double deviation = rotation_deviation(mesh.pose);
  const double* m = mesh.pose.data();  // column-major 4x4
  const Vec3 from_mesh = to_vec3(origin) - Vec3{m[12], m[13], m[14]};
  const Aabb& own = mesh.mesh.bounds();
  const double size = largest(to_vec3(own.min)) + largest(to_vec3(own.max)) +
                      2 * (largest(from_mesh) + largest(core.at)) + core.bounding_radius +
                      core.radius;
  const double law_1 = std::max(std::abs(m[12]), std::max(std::abs(m[13]), std::abs(m[14])));
  const double slack = (8 * deviation + 0x1p-45) * size + 0x8p-53 * law_1;
  unit_ = tree_.frame.unit();
  shrink_ = 1 - (8 * deviation + 0x1p-45);
  for (int k = 0; k < 3; ++k) {
    const Vec3 axis{m[4 * k], m[4 * k + 1], m[4 * k + 2]};
    const double shift = dot(axis, from_mesh) - tree_.frame.centre[k];
    const Extent extent = extent_along(core, axis);
    const double high = extent.high + slack, low = extent.low - slack;
    const double pad = 0x1p-50 * std::abs(tree_.frame.centre[k]);
    min_[k] = (shift + low - pad) / unit_;
    max_[k] = (shift + high + pad) / unit_;
    around_.min[k] = bvh::rounded_down(std::clamp(min_[k], -kFar, kFar));
    around_.max[k] = bvh::rounded_up(std::clamp(max_[k], -kFar, kFar));
    // A unit is a power of two; the sum is off by a rounding, of which the pad and the slack have
    // each their part.
    own_min_[k] = min_[k] * unit_ + tree_.frame.centre[k];
    own_max_[k] = max_[k] * unit_ + tree_.frame.centre[k];
  }
}

double MeshDescent::bound_of(const double (&low)[3], const double (&high)[3]) const {
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    const double gap = std::max(low[k] - max_[k], min_[k] - high[k]);
    if (gap > 0) square += gap * gap;
  }
  return std::sqrt(square) * unit_ * shrink_;
}

double MeshDescent::bound(std::uint32_t node) const {
  ++work_.volume_tests;
  const bvh::FloatBox& box = tree_.nodes[node].box;
  return bound_of({box.min[0], box.min[1], box.min[2]}, {box.max[0], box.max[1], box.max[2]});
}

// In the tree's units a corner is off by an ulp of the mesh's size, which the slack covers.
double MeshDescent::triangle_bound(std::uint32_t index) const {
  const Triangle triangle = mesh_.mesh.triangle(index);
  double low[3];
  double high[3];
  for (int k = 0; k < 3; ++k) {
    const double a = triangle.a.data()[k];
    const double b = triangle.b.data()[k];
    const double c = triangle.c.data()[k];
    low[k] = (std::min(a, std::min(b, c)) - tree_.frame.centre[k]) / unit_;
    high[k] = (std::max(a, std::max(b, c)) - tree_.frame.centre[k]) / unit_;
  }
  return bound_of(low, high);
}

bool MeshDescent::is_beyond(double bound, double limit) const {
  const bool is_pruned = bound > limit;
  work_.volume_rejections += is_pruned;
  return is_pruned;
}

Triangle MeshDescent::placed_triangle(std::uint32_t index) const {
  return narrowphase::place(mesh_.pose, mesh_.mesh.triangle(index));
}

Core MeshDescent::triangle(std::uint32_t index) const {
  ++work_.triangle_tests;
  return core_of(placed_triangle(index), origin_);
}

}  // namespace graze

#include <graze/engine/world/shapes/mesh_heights.h>
#include <graze/engine/world/shapes/pair_functions.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {

using narrowphase::Core;
using narrowphase::Vec3;

namespace {

// The support point is off by 31 u of the scale (core_gap.cpp), the dot product by 4 u more, and
// the normal by 11 u.
Height height_of(const Core& core, const PlacedHalfSpace& plane) {
  const Vec3 lowest = rounded_support(core, -plane.normal);
  const double size =
      core.bounding_radius + core.radius + 2 * largest(core.at) + std::abs(plane.offset);
  return {dot(plane.normal, lowest) - plane.offset, 0x40p-53 * size + plane.slack, lowest};
}

/// Where the lowest point of a shape is above the plane of a half-space, around an origin.
struct HeightAbovePlane {
  Eigen::Vector3d origin;
  PlacedHalfSpace plane;
  Height height;
};

HeightAbovePlane beside_plane(const PlacedShapeView& a, const PlacedShapeView& b) {
  const Eigen::Vector3d origin = middle_of(a.shape, a.pose);
  const Core core = core_of(a.shape, a.pose, origin);
  const PlacedHalfSpace plane = placed_half_space(*b.shape.as<HalfSpace>(), b.pose, origin);
  return {origin, plane, height_of(core, plane)};
}

ShapeDistance distance_above(const Height& height, const PlacedHalfSpace& plane,
                             const Eigen::Vector3d& origin) {
  const double lower = std::max(height.height - height.slack, 0.0);
  const Eigen::Vector3d lowest = in_world(height.lowest, origin);
  const Eigen::Vector3d down = to_eigen(-plane.normal);
  if (!(lower > 0)) return {0, 0, lowest, lowest, down, PairStatus::Converged};
  const Vec3 foot = height.lowest - plane.normal * height.height;
  return {height.height, lower, lowest, in_world(foot, origin), down, PairStatus::Converged};
}

bool are_opposite(const Vec3& a, const Vec3& b) {
  return a.x == -b.x && a.y == -b.y && a.z == -b.z;
}

HeightAbovePlane mesh_beside_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                                   double enough, Work& work) {
  const Mesh& mesh = *b.shape.as<Mesh>();
  const double* m = b.pose.data();
  const Eigen::Vector3d origin(m[12], m[13], m[14]);
  const PlacedHalfSpace plane = placed_half_space(*a.shape.as<HalfSpace>(), a.pose, origin);
  const PlacedMeshView placed{mesh, b.pose};
  return {origin, plane, MeshHeights(placed, plane, origin, work).lowest(enough)};
}

}  // namespace

bool intersect_plane(const PlacedShapeView& a, const PlacedShapeView& b) {
  const Height height = beside_plane(a, b).height;
  return !(height.height - height.slack > 0);
}

ShapeDistance distance_to_plane(const PlacedShapeView& a, const PlacedShapeView& b) {
  const HeightAbovePlane s = beside_plane(a, b);
  return distance_above(s.height, s.plane, s.origin);
}

bool intersect_planes(const PlacedShapeView& a, const PlacedShapeView& b) {
  return distance_of_planes(a, b).distance == 0;
}

ShapeDistance distance_of_planes(const PlacedShapeView& a, const PlacedShapeView& b) {
  const Eigen::Vector3d origin = middle_of(a.shape, a.pose);
  const PlacedHalfSpace of_a = placed_half_space(*a.shape.as<HalfSpace>(), a.pose, origin);
  const PlacedHalfSpace of_b = placed_half_space(*b.shape.as<HalfSpace>(), b.pose, origin);
  const Vec3 on_a = of_a.normal * of_a.offset;
  const Vec3 on_b = of_b.normal * of_b.offset;
  const double gap = -of_a.offset - of_b.offset;
  const double slack = of_a.slack + of_b.slack;
  if (are_opposite(of_a.normal, of_b.normal) && gap - slack > 0) {
    return {gap,
            gap - slack,
            in_world(on_a, origin),
            in_world(on_b, origin),
            to_eigen(of_a.normal),
            PairStatus::Converged};
  }
  // This is some point deep in both: in a direction that -n_a and -n_b share, unless they are
  // opposite.
  const double cosine = dot(of_a.normal, of_b.normal);
  const double determinant = 1 - cosine * cosine;
  Vec3 common = on_a;
  if (determinant > 0) {
    const double u = (of_a.offset - cosine * of_b.offset) / determinant;
    const double v = (of_b.offset - cosine * of_a.offset) / determinant;
    common = of_a.normal * u + of_b.normal * v;
  } else if (cosine > 0 && of_b.offset < of_a.offset) {
    common = on_b;
  }
  const Eigen::Vector3d point = in_world(common, origin);
  return {0, 0, point, point, to_eigen(of_a.normal), PairStatus::Converged};
}

bool intersect_mesh_plane(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  const Height height = mesh_beside_plane(a, b, 0, work).height;
  return !(height.height - height.slack > 0);
}

ShapeDistance distance_of_mesh_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                                     Work& work) {
  const double never = -std::numeric_limits<double>::infinity();
  const HeightAbovePlane s = mesh_beside_plane(a, b, never, work);
  return mirrored(distance_above(s.height, s.plane, s.origin));
}

}  // namespace graze

#include <graze/bvh/obb.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query_results.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/engine/world/pair_questions.h>
#include <graze/engine/world/placed_core.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/volumes/obb_rows.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace graze {
namespace {

using enum PairMethod;

// Rows and columns in the order of ShapeKind; below the diagonal it is mirrored.
constexpr std::size_t kKinds = kShapeKinds.size();
constexpr std::array<std::array<PairMethod, kKinds>, kKinds> kMethods{{
    {ExactSpheres, ExactSphereBox, ClosedForm, Cores, Cores, Cores, Cores, Plane, MeshVolume},
    {ExactSphereBox, BoxAxes, Cores, Cores, Cores, Cores, Cores, Plane, MeshVolume},
    {ClosedForm, Cores, ClosedForm, Cores, Cores, Cores, Cores, Plane, MeshCore},
    {Cores, Cores, Cores, Cores, Cores, Cores, Cores, Plane, MeshCore},
    {Cores, Cores, Cores, Cores, Cores, Cores, Cores, Plane, MeshCore},
    {Cores, Cores, Cores, Cores, Cores, Cores, Cores, Plane, MeshCore},
    {Cores, Cores, Cores, Cores, Cores, Cores, Cores, Plane, MeshCore},
    {Plane, Plane, Plane, Plane, Plane, Plane, Plane, Planes, MeshPlane},
    {MeshVolume, MeshVolume, MeshCore, MeshCore, MeshCore, MeshCore, MeshCore, MeshPlane, Meshes},
}};

Sphere placed_sphere(const PlacedShape& s) {
  const auto& sphere = *s.shape.as<Sphere>();
  return {place(s.pose, sphere.centre), sphere.radius};
}

Obb placed_box(const PlacedShape& s) {
  return {s.pose, s.shape.as<Box>()->half_extents};
}

PlacedMesh placed_mesh(const PlacedShape& s) {
  return {*s.shape.as<Mesh>(), s.pose};
}

/// As overlaps() of a sphere and an oriented box (law 3), of volumes that have been checked.
bool meet_sphere_box(const PlacedShape& a, const PlacedShape& b) {
  const Sphere sphere = placed_sphere(a);
  const Eigen::Vector3d& half = b.shape.as<Box>()->half_extents;
  const Sphere framed{narrowphase::point_into_frame(sphere.centre, b.pose), sphere.radius};
  return narrowphase::decide(framed, Aabb{-half, half}).is_hit;
}

bool intersect_mesh_volume(const PlacedShape& a, const PlacedShape& b, Work& work) {
  const PlacedMesh mesh = placed_mesh(b);
  if (a.shape.kind() == ShapeKind::Sphere) return intersects(mesh, placed_sphere(a), &work);
  return intersects(mesh, placed_box(a), &work);
}

}  // namespace

bool intersect_in_order(const PlacedShape& a, const PlacedShape& b, Work& work) {
  switch (pair_method(a.shape.kind(), b.shape.kind())) {
    case ExactSpheres:
      return overlaps(placed_sphere(a), placed_sphere(b));
    case ExactSphereBox:
      return meet_sphere_box(a, b);
    case BoxAxes:
      return narrowphase::may_overlap(narrowphase::row_of(placed_box(a)),
                                      narrowphase::row_of(placed_box(b)));
    case ClosedForm:
    case Cores:
      return intersect_cores(a, b, work);
    case Plane:
      return intersect_plane(a, b);
    case Planes:
      return intersect_planes(a, b);
    case MeshPlane:
      return intersect_mesh_plane(a, b, work);
    case MeshVolume:
      return intersect_mesh_volume(a, b, work);
    case MeshCore:
      return intersect_mesh_core(a, b, work);
    case Meshes:
      return intersects(placed_mesh(a), placed_mesh(b), &work);
  }
  throw UnsupportedPairError("shape pair: there is no such method");
}

namespace {

ShapeDistance distance_of_meshes(const PlacedShape& a, const PlacedShape& b, Work& work) {
  const MeshDistance found = distance(placed_mesh(a), placed_mesh(b), {}, &work);
  // Law 7: off by at most 4 ulp of the largest difference of coordinates.
  const Aabb& box_a = placed_mesh(a).mesh.bounds();
  const Aabb& box_b = placed_mesh(b).mesh.bounds();
  double reach = 0;
  const std::array<double, 3> of_a = placed_reach(a.pose, box_a);
  const std::array<double, 3> of_b = placed_reach(b.pose, box_b);
  for (int k = 0; k < 3; ++k)
    reach = std::max(reach, of_a[k] + of_b[k]);
  const narrowphase::Vec3 way = unit_or(to_vec3(found.point_b) - to_vec3(found.point_a), {0, 0, 1});
  return {found.distance, std::max(found.distance - 0x8p-53 * reach, 0.0),
          found.point_a,  found.point_b,
          to_eigen(way),  PairStatus::Converged};
}

/// What an exact test decides is beyond what the distance's own rounding says.
ShapeDistance agreeing(ShapeDistance found, bool is_hit) {
  if (is_hit) {
    found.distance = 0;
    found.lower_bound = 0;
  } else if (!(found.distance > 0)) {
    found.distance = std::numeric_limits<double>::denorm_min();
  }
  return found;
}

ShapeDistance distance_in_order(const PlacedShape& a, const PlacedShape& b, Work& work) {
  switch (pair_method(a.shape.kind(), b.shape.kind())) {
    case ExactSpheres:
    case ExactSphereBox:
    case BoxAxes:
      return agreeing(distance_of_cores(a, b, work), intersect_in_order(a, b, work));
    case ClosedForm:
    case Cores:
      return distance_of_cores(a, b, work);
    case Plane:
      return distance_to_plane(a, b);
    case Planes:
      return distance_of_planes(a, b);
    case MeshPlane:
      return distance_of_mesh_plane(a, b, work);
    case MeshVolume:
      return agreeing(distance_of_mesh_core(a, b, work), intersect_mesh_volume(a, b, work));
    case MeshCore:
      return distance_of_mesh_core(a, b, work);
    case Meshes:
      return distance_of_meshes(a, b, work);
  }
  throw UnsupportedPairError("shape pair: there is no such method");
}

}  // namespace

PairMethod pair_method(ShapeKind kind_a, ShapeKind kind_b) {
  const auto a = static_cast<std::size_t>(kind_a);
  const auto b = static_cast<std::size_t>(kind_b);
  if (a >= kKinds || b >= kKinds) throw InputError("shape kind: there is no such kind");
  return kMethods[a][b];
}

bool intersects(const Shape& shape_a, const Pose& pose_a, const Shape& shape_b, const Pose& pose_b,
                Work* work) {
  check_poses(pose_a, pose_b);
  CountedWork counted(work);
  const PlacedShape a{shape_a, pose_a};
  const PlacedShape b{shape_b, pose_b};
  return is_swapped(a, b) ? intersect_in_order(b, a, counted.work())
                          : intersect_in_order(a, b, counted.work());
}

ShapeDistance distance(const Shape& shape_a, const Pose& pose_a, const Shape& shape_b,
                       const Pose& pose_b, Work* work) {
  check_poses(pose_a, pose_b);
  CountedWork counted(work);
  const PlacedShape a{shape_a, pose_a};
  const PlacedShape b{shape_b, pose_b};
  if (!is_swapped(a, b)) return distance_in_order(a, b, counted.work());
  return mirrored(distance_in_order(b, a, counted.work()));
}

}  // namespace graze

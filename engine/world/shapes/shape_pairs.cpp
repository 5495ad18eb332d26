#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/obb.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/engine/world/fields/stand_in.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/half_space_pair.h>
#include <graze/engine/world/shapes/pair_functions.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>
#include <graze/narrowphase/volumes/spheres/sphere_stages.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace graze {
namespace {

using enum PairMethod;

// Rows and columns are in the order of ShapeKind; the table is symmetric.
constexpr std::size_t kKinds = kShapeKinds.size();
constexpr std::array<std::array<PairMethod, kKinds>, kKinds> kMethods = [] {
  // A height field is asked as a mesh is, and a plane as a half-space.
  constexpr std::array<std::array<PairMethod, kKinds - 2>, kKinds - 2> kOthers{{
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
  std::array<std::array<PairMethod, kKinds>, kKinds> methods{};
  const auto row_of = [](std::size_t kind) {
    constexpr auto kMesh = static_cast<std::size_t>(ShapeKind::Mesh);
    static_assert(kMesh + 3 == kKinds);
    if (kind == static_cast<std::size_t>(ShapeKind::Plane))
      return static_cast<std::size_t>(ShapeKind::HalfSpace);
    return std::min(kind, kMesh);
  };
  for (std::size_t a = 0; a < kKinds; ++a) {
    for (std::size_t b = 0; b < kKinds; ++b)
      methods[a][b] = kOthers[row_of(a)][row_of(b)];
  }
  return methods;
}();

Sphere placed_sphere(const PlacedShapeView& s) {
  const auto& sphere = *s.shape.as<Sphere>();
  return {narrowphase::place(s.pose, sphere.centre), sphere.radius};
}

PlacedMeshView placed_mesh(const PlacedShapeView& s) {
  return {*s.shape.as<Mesh>(), s.pose};
}

/// Returns intersects() of a sphere and an oriented box (law 3), which have been checked.
bool meet_sphere_box(const PlacedShapeView& a, const PlacedShapeView& b) {
  const Sphere sphere = placed_sphere(a);
  const Eigen::Vector3d& half = b.shape.as<Box>()->half_extents;
  const Sphere framed{narrowphase::point_into_frame(sphere.centre, b.pose), sphere.radius};
  return narrowphase::decide(framed, Aabb{-half, half}).is_hit;
}

bool intersect_mesh_volume(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  const PlacedMeshView mesh = placed_mesh(b);
  if (a.shape.kind() == ShapeKind::Sphere) return intersects(mesh, placed_sphere(a), &work);
  return intersects(mesh, placed_box(a), &work);
}

/// True for pairs whose every hit is in both boxes: those that are exact in the world's frame.
bool lies_in_boxes(PairMethod method) {
  return method == ExactSpheres || method == MeshVolume || method == Meshes;
}

/// Returns the radius of a ball about the shape's middle that lies in it, metres; 0 where none is
/// known at once.
double inner_radius(const Shape& shape) {
  if (const auto* s = shape.as<Sphere>()) return s->radius;
  if (const auto* s = shape.as<Box>()) {
    const double* h = s->half_extents.data();
    return std::min(h[0], std::min(h[1], h[2]));
  }
  if (const auto* s = shape.as<Capsule>()) return s->radius;
  if (const auto* s = shape.as<Cylinder>()) return std::min(s->radius, s->half_height);
  return 0;
}

/// True if the boxes share a point for sure: each holds its ball, which no pose and no rounding
/// makes smaller by a thousandth. Computing the boxes would cost more than the test of two shapes
/// that touch.
bool have_near_middles(const PlacedShapeView& a, const PlacedShapeView& b) {
  const double inner_a = inner_radius(a.shape), inner_b = inner_radius(b.shape);
  if (inner_a == 0 || inner_b == 0) return false;
  const Eigen::Vector3d s = middle_of(a.shape, a.pose), t = middle_of(b.shape, b.pose);
  double offset = 0;
  for (int i = 0; i < 3; ++i)
    offset = std::max(offset, std::abs(s.data()[i] - t.data()[i]));
  return offset <= 0.999 * (inner_a + inner_b);
}

BoxGap gap_of_boxes(const PlacedShapeView& a, const PlacedShapeView& b) {
  return gap_between(bounding_aabb({a.shape, a.pose}), bounding_aabb({b.shape, b.pose}));
}

bool intersect_in_order(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  switch (pair_method(a.shape.kind(), b.shape.kind())) {
    case ExactSpheres:
      return intersects(placed_sphere(a), placed_sphere(b));
    case ExactSphereBox:
      return meet_sphere_box(a, b);
    case BoxAxes:
      return intersect_boxes(a, b, work);
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

ShapeDistance distance_of_meshes(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  const MeshDistance found = distance(placed_mesh(a), placed_mesh(b), {}, &work);
  // By law 7 the distance is off by at most 4 ulp of the largest difference of coordinates.
  const Aabb& box_a = placed_mesh(a).mesh.bounds();
  const Aabb& box_b = placed_mesh(b).mesh.bounds();
  double largest = 0;
  const std::array<double, 3> of_a = largest_coordinates(a.pose, box_a);
  const std::array<double, 3> of_b = largest_coordinates(b.pose, box_b);
  for (int k = 0; k < 3; ++k)
    largest = std::max(largest, of_a[k] + of_b[k]);
  const narrowphase::Vec3 normal =
      unit_or(to_vec3(found.point_b) - to_vec3(found.point_a), {0, 0, 1});
  return {found.distance,   std::max(found.distance - 0x8p-53 * largest, 0.0),
          found.point_a,    found.point_b,
          to_eigen(normal), PairStatus::Converged};
}

ShapeDistance distance_in_order(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  switch (pair_method(a.shape.kind(), b.shape.kind())) {
    case ExactSpheres:
      return distance_of_spheres(a, b, intersect_checked(a, b, work), work);
    case ExactSphereBox:
      return distance_of_sphere_and_box(a, b, intersect_checked(a, b, work), work);
    case BoxAxes:
      return distance_of_boxes(a, b, intersect_checked(a, b, work), work);
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
      return distance_of_mesh_volume(a, b, intersect_mesh_volume(a, b, work), work);
    case MeshCore:
      return distance_of_mesh_core(a, b, work);
    case Meshes:
      return distance_of_meshes(a, b, work);
  }
  throw UnsupportedPairError("shape pair: there is no such method");
}

/// Returns the distance of two shapes that their boxes part, where only a tolerance brings them
/// together, or a test parts them by no more than rounding.
ShapeDistance parted(ShapeDistance found, const BoxGap& boxes) {
  const double sign = boxes.is_a_below ? 1 : -1;
  Eigen::Vector3d normal(0, 0, 0);
  normal.data()[boxes.axis] = sign;
  found.distance = found.lower_bound = boxes.gap;
  found.point_a.data()[boxes.axis] -= sign * (0.5 * boxes.gap);
  found.point_b.data()[boxes.axis] += sign * (0.5 * boxes.gap);
  found.normal = normal;
  return found;
}

ShapeDistance distance_in_boxes(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  ShapeDistance found = distance_in_order(a, b, work);
  const bool is_none = !(found.distance > std::numeric_limits<double>::denorm_min());
  if (!is_none || lies_in_boxes(pair_method(a.shape.kind(), b.shape.kind()))) return found;
  const BoxGap boxes = gap_of_boxes(a, b);
  return boxes.gap == 0 ? found : parted(found, boxes);
}

/// Returns the distance of a pair with one plane, or two.
ShapeDistance distance_of_plane(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  const HalfSpacePair by(a, b, work);
  ShapeDistance found = distance(by.a(), by.b(), &work);
  if (found.distance == 0) {
    // The points are in the half-space, but perhaps not in the plane.
    found.point_a = found.point_b = point_in_plane(a, b, found.point_a, work);
    return found;
  }
  if (!by.is_divided()) return found;
  const ShapeDistance behind = distance(by.a(1), by.b(1), &work);
  return behind.distance < found.distance ? behind : found;
}

/// Returns the distance of a pair with one height field, or two.
ShapeDistance distance_of_field(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  if (!is_field(a)) return mirrored(distance_of_field(b, a, work));
  const StandIn of_a = nearest_stand_in(a, b, [&](const Shape& mesh) {
    return distance({mesh, a.pose}, b, &work).distance;
  });
  return distance(of_a.view(), b, &work);
}

}  // namespace

PairMethod pair_method(ShapeKind kind_a, ShapeKind kind_b) {
  const auto a = static_cast<std::size_t>(kind_a);
  const auto b = static_cast<std::size_t>(kind_b);
  if (a >= kKinds || b >= kKinds) throw InputError("shape kind: there is no such kind");
  return kMethods[a][b];
}

bool intersect_in_boxes(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  if (has_plane(a, b)) {
    const HalfSpacePair by(a, b, work);
    return !by.is_divided() && intersect_in_boxes(by.a(), by.b(), work);
  }
  if (has_field(a, b)) {
    const StandIns by(a, b);
    return by.are_near() && intersect_in_boxes(by.a.view(), by.b.view(), work);
  }
  return is_swapped(a, b) ? intersect_in_order(b, a, work) : intersect_in_order(a, b, work);
}

bool intersect_checked(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  return intersect_in_boxes(a, b, work) &&
         (lies_in_boxes(pair_method(a.shape.kind(), b.shape.kind())) || have_near_middles(a, b) ||
          gap_of_boxes(a, b).gap == 0);
}

template <typename>
bool intersects(const PlacedShapeView& shape_a, const PlacedShapeView& shape_b, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    check_poses(shape_a.pose, shape_b.pose);
    CountedWork counted(work);
    if (has_plane(shape_a, shape_b)) {
      const HalfSpacePair by(shape_a, shape_b, counted.work());
      return !by.is_divided() && intersects(by.a(), by.b(), &counted.work());
    }
    if (!has_field(shape_a, shape_b)) return intersect_checked(shape_a, shape_b, counted.work());
    const StandIns by(shape_a, shape_b);
    return by.are_near() && intersect_checked(by.a.view(), by.b.view(), counted.work());
  });
}
template bool intersects<void>(const PlacedShapeView&, const PlacedShapeView&, Work*);

ShapeDistance distance_of_checked(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  return is_swapped(a, b) ? mirrored(distance_in_boxes(b, a, work)) : distance_in_boxes(a, b, work);
}

template <typename>
ShapeDistance distance(const PlacedShapeView& a, const PlacedShapeView& b, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> ShapeDistance {
    check_poses(a.pose, b.pose);
    CountedWork counted(work);
    if (has_plane(a, b)) return distance_of_plane(a, b, counted.work());
    if (has_field(a, b)) return distance_of_field(a, b, counted.work());
    return distance_of_checked(a, b, counted.work());
  });
}
template ShapeDistance distance<void>(const PlacedShapeView&, const PlacedShapeView&, Work*);

}  // namespace graze

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/ray_slabs.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/world/fields/field_ray.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_ray.h>
#include <graze/engine/world/shapes/half_space_pair.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/convex/core/core_ray.h>

#include <cmath>

namespace graze {
namespace {

using narrowphase::CoreRayHit;
using narrowphase::Vec3;

Vec3 unit_direction(const Ray& ray) {
  const bvh::ScaledDirection scaled = bvh::scaled_direction(ray.direction.data());
  const double* d = scaled.component;
  const double length = bvh::length_of(scaled);
  return {d[0] / length, d[1] / length, d[2] / length};
}

std::optional<CoreRayHit> cast_at_half_space(const HalfSpace& half_space, const Pose& pose,
                                             const Ray& ray, const Vec3& direction) {
  const PlacedHalfSpace placed = placed_half_space(half_space, pose, ray.origin);
  if (placed.offset >= 0) return CoreRayHit{0, -direction};
  const double slope = dot(placed.normal, direction);
  if (!(slope < 0)) return std::nullopt;
  return CoreRayHit{placed.offset / slope, placed.normal};
}

/// Casts a ray at a plane, as at the half-space behind it as seen from where the ray begins.
std::optional<CoreRayHit> cast_at_plane(const graze::Plane& plane, const Pose& pose, const Ray& ray,
                                        const Vec3& direction) {
  const HalfSpace front = front_of(plane);
  const PlacedHalfSpace placed = placed_half_space(front, pose, ray.origin);
  const bool is_behind = placed.offset > 0;
  return cast_at_half_space(is_behind ? back_of(plane) : front, pose, ray, direction);
}

}  // namespace

template <typename>
std::optional<RayHit> cast_ray(const PlacedShapeView& placed, const Ray& ray, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<RayHit> {
    check_ray(ray, "ray");
    const Shape& shape = placed.shape;
    const Pose& pose = placed.pose;
    check_pose(pose, "pose");
    if (const auto* mesh = shape.as<Mesh>())
      return cast_ray(PlacedMeshView{*mesh, pose}, ray, work);
    if (const auto* field = shape.as<HeightField>()) {
      CountedWork counted(work);
      return cast_at_field(*field, pose, ray, counted.work());
    }
    const Vec3 direction = unit_direction(ray);
    std::optional<CoreRayHit> found;
    if (const auto* half_space = shape.as<HalfSpace>()) {
      found = cast_at_half_space(*half_space, pose, ray, direction);
    } else if (const auto* plane = shape.as<graze::Plane>()) {
      found = cast_at_plane(*plane, pose, ray, direction);
    } else {
      const Eigen::Vector3d middle = middle_of(shape, pose);
      found =
          cast_ray(core_of(shape, pose, middle), to_vec3(ray.origin) - to_vec3(middle), direction);
    }
    if (!found || !(found->distance <= ray.max_distance)) return std::nullopt;
    const Vec3 point = to_vec3(ray.origin) + direction * found->distance;
    return RayHit{found->distance, to_eigen(point), to_eigen(found->normal)};
  });
}
template std::optional<RayHit> cast_ray<void>(const PlacedShapeView&, const Ray&, Work*);

}  // namespace graze

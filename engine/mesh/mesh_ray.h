#pragma once

#include <graze/bvh/ray.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/mesh/query_settings.h>
#include <graze/engine/work.h>
#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace graze {

/// The value of RayHit::triangle where no mesh was hit.
inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

/// Says where a ray meets something first.
struct RayHit {
  double distance;         ///< metres along the ray
  Eigen::Vector3d point;   ///< metres, in the world's frame
  Eigen::Vector3d normal;  ///< unit, against the ray: of the surface, or of a triangle on the side
                           ///< that the ray comes from; the ray's own where there is no other
  std::uint32_t triangle =
      kNoTriangle;  ///< the number of the triangle of the mesh or height field that was hit
  std::uint16_t material = 0;  ///< the material of that triangle, if it has one

  bool operator==(const RayHit&) const = default;
};

/// Returns the placed triangle that the ray meets first (law 1), if any: the hit of least distance,
/// of equal ones that of the lowest index. What a hit is, and how far off the values may be, is as
/// for one triangle (narrowphase/triangle_ray.h): nothing slips through between neighbours. A ray
/// takes O(log n) for compact meshes. The first ray at a mesh has its tree collapsed for rays,
/// O(n), which then takes up to 20 bytes a triangle more. Throws as check_ray() does, and PoseError
/// for a pose that is refused by law 10 or by law 1.
std::optional<RayHit> cast_ray(const PlacedMeshView& mesh, const Ray& ray, Work* work = nullptr);

/// True if the ray meets any placed triangle. This finds less than cast_ray(), and throws as it
/// does.
bool intersects(const PlacedMeshView& mesh, const Ray& ray, Work* work = nullptr);

/// Answers cast_ray() for many rays on this thread: what depends on the mesh and its pose alone is
/// computed once. `hits`, which keeps its memory, has an element for each ray. Throws as cast_ray()
/// does, for any of the rays, and then leaves `hits` as they are.
void cast_rays(const PlacedMeshView& mesh, std::span<const Ray> rays,
               std::vector<std::optional<RayHit>>& hits, Work* work = nullptr);

/// Answers cast_ray() for each of many rays, a million say, which threads share: the same answers
/// bit for bit, in the rays' order. Throws as cast_ray() does, before the first answer, and names
/// the ray by its index.
std::vector<std::optional<RayHit>> cast_rays(const PlacedMeshView& mesh, std::span<const Ray> rays,
                                             const BatchSettings& batch = {}, Work* work = nullptr);

/// Returns all triangles that the ray meets, by distance, then by index: a ray through an edge
/// meets both. Throws as cast_ray() does.
std::vector<RayHit> cast_ray_all(const PlacedMeshView& mesh, const Ray& ray, Work* work = nullptr);

}  // namespace graze

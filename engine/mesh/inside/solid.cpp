#include <graze/bvh/error.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/inside/solid.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <span>
#include <string>

namespace graze {
namespace {

bool is_any_part_inside(const PlacedMeshView& inner, const PlacedMeshView& outer, Work& work) {
  const std::span<const std::uint32_t> parts = inner.mesh.component_vertices();
  return std::any_of(parts.begin(), parts.end(), [&](std::uint32_t vertex) {
    const Eigen::Vector3d point = narrowphase::place(inner.pose, inner.mesh.vertices()[vertex]);
    return is_moved_point_enclosed(outer, point, work);
  });
}

}  // namespace

void check_interior(Interior interior) {
  if (interior == Interior::Surface || interior == Interior::Solid) return;
  throw InputError("interior: there is no interior " + std::to_string(static_cast<int>(interior)));
}

void check_hit(Hit hit) {
  if (hit == Hit::Touching || hit == Hit::Crossing || hit == Hit::Solid) return;
  throw InputError("hit: there is no such hit as " + std::to_string(static_cast<int>(hit)));
}

Touch touch_of(Hit hit) {
  return hit == Hit::Crossing ? Touch::Exclude : Touch::Include;
}

bool is_either_inside(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, Work& work) {
  return is_any_part_inside(mesh_a, mesh_b, work) || is_any_part_inside(mesh_b, mesh_a, work);
}

}  // namespace graze

#include <graze/bvh/error.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/inside/solid.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <span>
#include <string>

namespace graze {
namespace {

bool is_any_part_inside(const PlacedMesh& inner, const PlacedMesh& outer, Work& work) {
  const std::span<const std::uint32_t> parts = inner.mesh.component_vertices();
  return std::any_of(parts.begin(), parts.end(), [&](std::uint32_t vertex) {
    const Eigen::Vector3d point = narrowphase::place(inner.pose, inner.mesh.vertices()[vertex]);
    return is_moved_point_enclosed(outer, point, work);
  });
}

}  // namespace

void check_interior(const QuerySettings& settings) {
  if (settings.interior == Interior::Surface) return;
  if (settings.interior != Interior::Solid) {
    throw InputError("interior: there is no interior " +
                     std::to_string(static_cast<int>(settings.interior)));
  }
  if (settings.touch != Touch::Include) {
    throw InputError("interior: Interior::Solid needs Touch::Include");
  }
}

bool is_either_inside(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, Work& work) {
  return is_any_part_inside(mesh_a, mesh_b, work) || is_any_part_inside(mesh_b, mesh_a, work);
}

}  // namespace graze

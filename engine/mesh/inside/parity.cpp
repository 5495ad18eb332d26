#include <graze/bvh/traverse/traverse_volume.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/inside/parity_ray.h>

#include <limits>
#include <string>

namespace graze {
namespace {

/// All that lies beyond the point on its ray, rounded outward.
bvh::FloatBox box_along(const AxisRay& direction, const bvh::LocalFrame& frame,
                        const Eigen::Vector3d& point) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  bvh::FloatBox box = frame.to_local({point, point});
  if (direction.side == narrowphase::LineCrossing::Above) {
    box.max[direction.axis] = kInfinity;
  } else {
    box.min[direction.axis] = -kInfinity;
  }
  return box;
}

}  // namespace

void check_closed(const Mesh& mesh, const char* what) {
  const Topology& topology = mesh.topology();
  if (topology.is_closed) return;
  throw MeshError(std::string(what) + " is not closed: it has " +
                  std::to_string(topology.boundary_edges) + " boundary edge" +
                  (topology.boundary_edges == 1 ? "" : "s"));
}

bool is_moved_point_enclosed(const Mesh& mesh, const Eigen::Vector3d& point, Work& work) {
  const bvh::Tree& tree = tree_of(mesh, &work);
  const AxisRay direction = shortest_ray(mesh.bounds(), point);
  const bvh::FloatBox box = box_along(direction, tree.frame, point);
  const auto is_apart = [&](std::uint32_t node) {
    return !bvh::overlap(tree.nodes[node].box, box);
  };
  const auto triangle_at = [&](std::uint32_t index) { return mesh.triangle(index); };
  return is_crossed_oddly(tree, is_apart, triangle_at, point, direction, work);
}

}  // namespace graze

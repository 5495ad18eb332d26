#include <graze/bvh/traverse/traverse_volume.h>
#include <graze/engine/mesh/data/directed_edges.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/inside/parity_ray.h>

#include <limits>
#include <string>
#include <tuple>

namespace graze {
namespace {

/// Returns the box around all that lies beyond the point on its ray, rounded outward.
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

/// Returns the first boundary edge, in the order of triangles, of a mesh that is not closed.
TriangleEdge first_boundary_edge(const Mesh& mesh) {
  TriangleEdge first{std::numeric_limits<std::uint32_t>::max(), 0};
  for_each_edge(directed_edges_of(mesh), [&](std::span<const DirectedEdge> edge) {
    const TriangleEdge& of = edge.front().of;
    if (edge.size() % 2 == 1 && std::tie(of.triangle, of.k) < std::tie(first.triangle, first.k))
      first = of;
  });
  return first;
}

}  // namespace

void check_closed(const Mesh& mesh, const char* what) {
  const Topology& topology = mesh.topology();
  if (topology.is_closed) return;
  const TriangleEdge first = first_boundary_edge(mesh);
  const TriangleIndices& triangle = mesh.triangles()[first.triangle];
  throw MeshError(std::string(what) + " is not closed: it has " +
                      std::to_string(topology.boundary_edges) + " boundary edge" +
                      (topology.boundary_edges == 1 ? "" : "s") + ", the first from vertex " +
                      std::to_string(triangle[static_cast<std::size_t>(first.k)]) + " to vertex " +
                      std::to_string(triangle[static_cast<std::size_t>((first.k + 1) % 3)]) +
                      " of triangle " + std::to_string(first.triangle),
                  {.element = "triangle", .index = first.triangle});
}

namespace {

/// Calls `on_crossed` for each triangle that crosses the ray, as `crossing(triangle)` says about
/// the line along its axis.
template <typename Crossing, typename OnCrossed>
void for_each_crossed(const Mesh& mesh, const Eigen::Vector3d& point, const AxisRay& direction,
                      Work& work, Crossing&& crossing, OnCrossed&& on_crossed) {
  const bvh::Tree& tree = tree_of(mesh, &work);
  const bvh::FloatBox box = box_along(direction, tree.frame, point);
  const auto is_apart = [&](std::uint32_t node) {
    return !bvh::overlap(tree.nodes[node].box, box);
  };
  const auto crossing_at = [&](std::uint32_t index) { return crossing(mesh.triangle(index)); };
  for_each_crossed(tree, is_apart, crossing_at, direction, work, on_crossed);
}

template <typename OnCrossed>
void for_each_crossed(const Mesh& mesh, const Eigen::Vector3d& point, Work& work,
                      OnCrossed&& on_crossed) {
  const AxisRay direction = shortest_ray(mesh.bounds(), point);
  const auto crossing = [&](const Triangle& triangle) {
    return narrowphase::cross_axis_line(triangle, point.data(), direction.axis);
  };
  for_each_crossed(mesh, point, direction, work, crossing, on_crossed);
}

}  // namespace

bool is_moved_point_enclosed(const Mesh& mesh, const Eigen::Vector3d& point, Work& work) {
  bool is_odd = false;
  for_each_crossed(mesh, point, work, [&](std::uint32_t) { is_odd = !is_odd; });
  return is_odd;
}

bool is_on_or_enclosed(const Mesh& mesh, const Eigen::Vector3d& point, Work& work) {
  const AxisRay direction = shortest_ray(mesh.bounds(), point);
  CrossingsAndContacts seen(point, direction.axis, work);
  bool is_odd = false;
  for_each_crossed(
      mesh, point, direction, work,
      [&](const Triangle& triangle) { return seen.crossing(triangle); },
      [&](std::uint32_t) { is_odd = !is_odd; });
  return seen.is_on() || is_odd;
}

void crossed_triangles(const Mesh& mesh, const narrowphase::FaceSample& sample, Work& work,
                       std::vector<std::uint32_t>& triangles) {
  triangles.clear();
  const Eigen::Vector3d& corner = sample.triangle.a;
  const AxisRay direction = shortest_ray(mesh.bounds(), corner);
  const auto crossing = [&](const Triangle& triangle) {
    return narrowphase::cross_axis_line(triangle, sample, direction.axis);
  };
  for_each_crossed(mesh, corner, direction, work, crossing,
                   [&](std::uint32_t index) { triangles.push_back(index); });
}

}  // namespace graze

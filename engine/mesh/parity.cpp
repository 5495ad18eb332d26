#include <graze/bvh/traverse_volume.h>
#include <graze/engine/mesh/parity.h>
#include <graze/narrowphase/axis_line.h>

#include <limits>
#include <string>

namespace graze {
namespace {

using narrowphase::LineCrossing;

/// An axis and a side of it: the way out of a mesh's bounds.
struct Way {
  int axis;
  LineCrossing side;
};

/// The shortest way out. Any would do: in a closed mesh the numbers of crossings above and below a
/// point are both odd or both even, along every axis.
Way way_out(const Aabb& bounds, const Eigen::Vector3d& point) {
  Way way{0, LineCrossing::Above};
  double shortest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double up = bounds.max.data()[k] - point.data()[k];
    const double down = point.data()[k] - bounds.min.data()[k];
    if (up < shortest) way = {k, LineCrossing::Above}, shortest = up;
    if (down < shortest) way = {k, LineCrossing::Below}, shortest = down;
  }
  return way;
}

/// All that lies beyond the point on its way, rounded outward.
bvh::FloatBox box_along(const Way& way, const bvh::LocalFrame& frame,
                        const Eigen::Vector3d& point) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  bvh::FloatBox box = frame.to_local({point, point});
  if (way.side == LineCrossing::Above) {
    box.max[way.axis] = kInfinity;
  } else {
    box.min[way.axis] = -kInfinity;
  }
  return box;
}

}  // namespace

void check_closed(const Mesh& mesh) {
  const Topology& topology = mesh.topology();
  if (topology.is_closed) return;
  throw MeshError("the mesh is not closed: it has " + std::to_string(topology.boundary_edges) +
                  " boundary edge" + (topology.boundary_edges == 1 ? "" : "s"));
}

bool is_moved_point_enclosed(const Mesh& mesh, const Eigen::Vector3d& point, Work& work) {
  const bvh::Tree& tree = mesh.tree(&work);
  const Way way = way_out(mesh.bounds(), point);
  const bvh::FloatBox box = box_along(way, tree.frame, point);
  const auto is_apart = [&](std::uint32_t node) {
    ++work.volume_tests;
    const bool is_pruned = !bvh::overlap(tree.nodes[node].box, box);
    work.volume_rejections += is_pruned;
    return is_pruned;
  };
  bool is_odd = false;
  const auto count_leaf = [&](const bvh::Node& leaf) {
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const Triangle triangle = mesh.triangle(tree.primitives[i]);
      is_odd ^= narrowphase::cross_axis_line(triangle, point.data(), way.axis) == way.side;
    }
    return bvh::Walk::Continue;
  };
  bvh::traverse_volume(tree, is_apart, count_leaf);
  return is_odd;
}

}  // namespace graze

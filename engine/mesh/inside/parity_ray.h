#pragma once

// What the counts of crossings share. Private to engine/mesh.

#include <graze/bvh/traverse/traverse_volume.h>
#include <graze/bvh/tree/tree.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/ray/axis_line.h>

#include <limits>

namespace graze {

/// The ray of a point along an axis, to one side.
struct AxisRay {
  int axis;
  narrowphase::LineCrossing side;
};

/// The one that leaves the bounds soonest. Any would do: in a closed mesh the numbers of crossings
/// above and below a point are both odd or both even, along every axis.
inline AxisRay shortest_ray(const Aabb& bounds, const Eigen::Vector3d& point) {
  using narrowphase::LineCrossing;
  AxisRay direction{0, LineCrossing::Above};
  double shortest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double up = bounds.max.data()[k] - point.data()[k];
    const double down = point.data()[k] - bounds.min.data()[k];
    if (up < shortest) direction = {k, LineCrossing::Above}, shortest = up;
    if (down < shortest) direction = {k, LineCrossing::Below}, shortest = down;
  }
  return direction;
}

/// Calls `on_crossed(index)` for each triangle that crosses the moved point's ray, where
/// `crossing_at(index)` says that it crosses the line of that. No node for which `is_apart(node)`
/// speaks may hold one that does.
template <typename Apart, typename CrossingAt, typename OnCrossed>
void for_each_crossed(const bvh::Tree& tree, Apart&& is_apart, CrossingAt&& crossing_at,
                      const AxisRay& direction, Work& work, OnCrossed&& on_crossed) {
  ++work.points_tested;
  const auto is_counted_apart = [&](std::uint32_t node) {
    ++work.volume_tests;
    const bool is_pruned = is_apart(node);
    work.volume_rejections += is_pruned;
    return is_pruned;
  };
  const auto count_leaf = [&](const bvh::Node& leaf) {
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      if (crossing_at(tree.primitives[i]) == direction.side) on_crossed(tree.primitives[i]);
    }
    return bvh::Walk::Continue;
  };
  bvh::traverse_volume(tree, is_counted_apart, count_leaf);
}

/// Whether an odd number of triangles do.
template <typename Apart, typename CrossingAt>
bool is_crossed_oddly(const bvh::Tree& tree, Apart&& is_apart, CrossingAt&& crossing_at,
                      const AxisRay& direction, Work& work) {
  bool is_odd = false;
  for_each_crossed(tree, is_apart, crossing_at, direction, work,
                   [&](std::uint32_t) { is_odd = !is_odd; });
  return is_odd;
}

}  // namespace graze

#pragma once

// The counts of crossings share this. It is private to engine/mesh.

#include <graze/bvh/traverse/traverse_volume.h>
#include <graze/bvh/tree/tree.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/ray/axis_line.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>

#include <algorithm>
#include <limits>

namespace graze {

/// The ray of a point along an axis, to one side.
struct AxisRay {
  int axis;
  narrowphase::LineCrossing side;
};

/// Returns the ray that leaves the bounds soonest. Any would do: in a closed mesh the numbers of
/// crossings above and below a point are both odd or both even, along every axis.
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

/// Finds how triangles cross the line of a moved point along an axis, and whether the point itself
/// lies on one: nodes that are apart from its ray are apart from it.
class CrossingsAndContacts {
 public:
  CrossingsAndContacts(const Eigen::Vector3d& point, int axis, Work& work)
      : point_(point), axis_(axis), work_(work) {}

  narrowphase::LineCrossing crossing(const Triangle& triangle) {
    is_on_ |= is_around(triangle) && holds(triangle);
    return narrowphase::cross_axis_line(triangle, point_.data(), axis_);
  }

  bool is_on() const { return is_on_; }

 private:
  /// True if the box of a triangle holds the point.
  bool is_around(const Triangle& triangle) const {
    bool is_around = true;
    for (int k = 0; k < 3; ++k) {
      const double a = triangle.a.data()[k], b = triangle.b.data()[k], c = triangle.c.data()[k];
      is_around &= std::min(a, std::min(b, c)) <= point_.data()[k];
      is_around &= std::max(a, std::max(b, c)) >= point_.data()[k];
    }
    return is_around;
  }

  bool holds(const Triangle& triangle) const {
    ++work_.triangle_tests;
    const narrowphase::Decision decision = narrowphase::decide(triangle, Aabb{point_, point_});
    work_.exact_tests += decision.stage == narrowphase::Stage::Exact;
    return decision.is_hit;
  }

  const Eigen::Vector3d& point_;
  int axis_;
  Work& work_;
  bool is_on_ = false;
};

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

/// True if an odd number of triangles cross the ray.
template <typename Apart, typename CrossingAt>
bool is_crossed_oddly(const bvh::Tree& tree, Apart&& is_apart, CrossingAt&& crossing_at,
                      const AxisRay& direction, Work& work) {
  bool is_odd = false;
  for_each_crossed(tree, is_apart, crossing_at, direction, work,
                   [&](std::uint32_t) { is_odd = !is_odd; });
  return is_odd;
}

}  // namespace graze

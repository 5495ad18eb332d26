// This counts crossings of placed triangles, in the frame of the question. A triangle that crosses
// the moved line for every small e meets, closed as it is, the line through the point itself, and
// on the same side: so nodes that are apart from that ray by law 5's slack hold none. The ray is
// handed to relative_frame() as a flat box, for which that function bounds which placed triangles
// meet it.

#include <graze/bvh/skins/node_separation.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/inside/parity_ray.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/placing/relative_frame.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace graze {
namespace {

using narrowphase::LineCrossing;

constexpr double kUnitRoundoff = 0x1p-53;
constexpr double kLargest = std::numeric_limits<double>::max();

/// Returns a box around all points of the mesh's bounds, placed by law 1. With c and h the centre
/// and half size of the bounds, R x + t lies within |R| h of R c + t. Law 1 rounds a placed point,
/// and the placed centre, six times each, every time to a value of at most the largest coordinate,
/// and the lines below round h, |R| h and the sums another ten times: 32 u of that coordinate, and
/// underflow, cover all.
Aabb placed_bounds(const PlacedMeshView& placed) {
  const Aabb& bounds = placed.mesh.bounds();
  const double* m = placed.pose.data();  // column-major 4x4
  const std::array<double, 3> largest = largest_coordinates(placed.pose, bounds);
  const bvh::LocalFrame frame = bvh::LocalFrame::around(bounds);
  const Eigen::Vector3d centre = narrowphase::place(
      placed.pose, Eigen::Vector3d(frame.centre[0], frame.centre[1], frame.centre[2]));
  Aabb box;
  for (int i = 0; i < 3; ++i) {
    double half = 32 * kUnitRoundoff * largest[i] + 0x1p-1060;
    for (int k = 0; k < 3; ++k) {
      const double size =
          std::max(bounds.max.data()[k] - frame.centre[k], frame.centre[k] - bounds.min.data()[k]);
      half += std::abs(m[4 * k + i]) * size;
    }
    box.min.data()[i] = std::max(centre.data()[i] - half, -kLargest);
    box.max.data()[i] = std::min(centre.data()[i] + half, kLargest);
  }
  return box;
}

/// True if a point that is somewhere in `around` may be in the box.
bool is_within(const Aabb& box, const Aabb& around) {
  bool is_inside = true;
  for (int k = 0; k < 3; ++k) {
    is_inside &=
        box.min.data()[k] <= around.max.data()[k] && around.min.data()[k] <= box.max.data()[k];
  }
  return is_inside;
}

/// Returns a box around all that may be the point, and all beyond it on its ray, as far as the
/// bounds.
Aabb ray_from(const Aabb& around, const AxisRay& direction, const Aabb& bounds) {
  Aabb ray = around;
  double& low = ray.min.data()[direction.axis];
  double& high = ray.max.data()[direction.axis];
  if (direction.side == LineCrossing::Above) {
    high = std::max(high, bounds.max.data()[direction.axis]);
  } else {
    low = std::min(low, bounds.min.data()[direction.axis]);
  }
  return ray;
}

/// A flat box in a frame of its own, as a tree of one node.
struct FramedRay {
  FramedRay(const Aabb& box, const Pose& ray_pose)
      : bounds(box),
        pose(ray_pose),
        deviation(rotation_deviation(ray_pose)),
        frame(bvh::LocalFrame::around(box)),
        node{frame.to_local(box), 0, 1} {}

  Aabb bounds;
  Pose pose;
  double deviation;
  bvh::LocalFrame frame;
  bvh::Node node;
};

template <typename CrossingAt>
bool is_odd_along(const PlacedMeshView& placed, const FramedRay& ray, CrossingAt&& crossing_at,
                  const AxisRay& direction, Work& work) {
  const bvh::Tree& tree = tree_of(placed.mesh, &work);
  const bvh::RelativeFrame relative = relative_frame(
      {placed.pose, rotation_deviation(placed.pose), tree.frame, placed.mesh.bounds()},
      {ray.pose, ray.deviation, ray.frame, ray.bounds});
  const bvh::NodeSeparation separation(relative, tree.nodes, {&ray.node, 1});
  const auto is_apart = [&](std::uint32_t node) { return separation.are_apart(node, 0); };
  return is_crossed_oddly(tree, is_apart, crossing_at, direction, work);
}

/// The ray of a point, which is somewhere in `around`, from which it leaves a placed mesh soonest.
struct PointRay {
  PointRay(const Aabb& bounds, const Aabb& around)
      : direction(shortest_ray(bounds, around.min)),
        framed(ray_from(around, direction, bounds), Pose::Identity()) {}

  AxisRay direction;
  FramedRay framed;
};

/// True if a point that is as near as can be to one in `around` is enclosed, where
/// `crossing(triangle, axis)` says how a placed triangle crosses its line along an axis.
template <typename Crossing>
bool is_enclosed_near(const PlacedMeshView& placed, const Aabb& around, Crossing&& crossing,
                      Work& work) {
  const Aabb bounds = placed_bounds(placed);
  if (!is_within(bounds, around)) return false;
  const PointRay ray(bounds, around);
  const auto crossing_at = [&](std::uint32_t index) {
    return crossing(narrowphase::place(placed.pose, placed.mesh.triangle(index)),
                    ray.direction.axis);
  };
  return is_odd_along(placed, ray.framed, crossing_at, ray.direction, work);
}

}  // namespace

bool is_moved_point_enclosed(const PlacedMeshView& placed, const Eigen::Vector3d& point,
                             Work& work) {
  const auto crossing = [&](const Triangle& triangle, int axis) {
    return narrowphase::cross_axis_line(triangle, point.data(), axis);
  };
  return is_enclosed_near(placed, {point, point}, crossing, work);
}

bool is_on_or_enclosed(const PlacedMeshView& placed, const Eigen::Vector3d& point, Work& work) {
  const Aabb bounds = placed_bounds(placed);
  if (!is_within(bounds, {point, point})) return false;
  const PointRay ray(bounds, {point, point});
  CrossingsAndContacts seen(point, ray.direction.axis, work);
  const auto crossing_at = [&](std::uint32_t index) {
    return seen.crossing(narrowphase::place(placed.pose, placed.mesh.triangle(index)));
  };
  const bool is_odd = is_odd_along(placed, ray.framed, crossing_at, ray.direction, work);
  return seen.is_on() || is_odd;
}

bool is_sample_enclosed(const PlacedMeshView& placed, const narrowphase::FaceSample& sample,
                        Work& work) {
  const auto crossing = [&](const Triangle& triangle, int axis) {
    return narrowphase::cross_axis_line(triangle, sample, axis);
  };
  const Eigen::Vector3d& corner = sample.triangle.a;
  return is_enclosed_near(placed, {corner, corner}, crossing, work);
}

bool is_sample_enclosed(const PlacedMeshView& placed, const narrowphase::RationalSample& sample,
                        Work& work) {
  const auto crossing = [&](const Triangle& triangle, int axis) {
    return narrowphase::cross_axis_line(triangle, sample, axis);
  };
  return is_enclosed_near(placed, sample.around, crossing, work);
}

// The ray is half of the flat box from -half_length to half_length, so that it is a box of law 3,
// centred.
bool is_moved_centre_enclosed(const PlacedMeshView& placed, const Obb& box, Work& work) {
  const double* m = box.pose.data();
  const Aabb bounds = placed_bounds(placed);
  double half_length = 0;
  for (int i = 0; i < 3; ++i) {
    const double offset = std::max(std::abs(bounds.min.data()[i] - m[12 + i]),
                                   std::abs(bounds.max.data()[i] - m[12 + i]));
    half_length = std::min(half_length + 1.01 * offset, kLargest);
  }
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  const AxisRay direction{0, LineCrossing::Above};
  const Eigen::Vector3d end(half_length, 0, 0);
  const FramedRay ray({-end, end}, box.pose);
  const auto crossing_at = [&](std::uint32_t index) {
    return narrowphase::cross_axis_line(
        narrowphase::into_frame(narrowphase::place(placed.pose, placed.mesh.triangle(index)),
                                box.pose),
        origin.data(), direction.axis);
  };
  return is_odd_along(placed, ray, crossing_at, direction, work);
}

}  // namespace graze

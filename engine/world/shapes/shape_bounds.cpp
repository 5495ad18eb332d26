#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shapes/half_space_pair.h>
#include <graze/engine/world/shapes/next_double.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace graze {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

double below(double value) {
  return std::max(next_down(value), -kLargest);
}

double above(double value) {
  return std::min(next_up(value), kLargest);
}

// Computed distances are off by at most 128 u of the sizes of both shapes and the distance between
// them (core_gap.cpp): each box has room for twice its share, so that boxes are no farther apart
// than these distances.
constexpr double kDistanceShare = 0x100p-53;

// The shape as law 3 reads it, or a ray, is the set of all p with R^T (p - t) in its own frame: off
// from R x + t by R^-T (I - R^T R) x, below 1.74 dev of the sum of the coordinates of x, and that
// sum is below 1.74 of the bounding radius; a radius is read likewise.
constexpr double kReadings = 4;

void give_room(Aabb& box, int i, double room) {
  box.min.data()[i] -= room;
  box.max.data()[i] += room;
}

/// Returns the box around a turned box, by its projected radius along each axis of the world.
Aabb bounds_of_box(const Box& shape, const Pose& pose, double deviation) {
  const double* m = pose.data();  // column-major 4x4
  const double* half = shape.half_extents.data();
  const double size = (half[0] + half[1]) + half[2];
  const double pad = 0x20p-53 * size;
  const double room = (kDistanceShare + kReadings * deviation) * size;
  Aabb box;
  for (int i = 0; i < 3; ++i) {
    const double projected_radius =
        ((std::abs(m[i]) * half[0] + std::abs(m[4 + i]) * half[1]) + std::abs(m[8 + i]) * half[2]) +
        pad;
    box.max.data()[i] = above(m[12 + i] + projected_radius);
    box.min.data()[i] = below(m[12 + i] - projected_radius);
    give_room(box, i, room);
  }
  return box;
}

// A support point along an axis is off by less than 20 u of its shape's size (core_gap.cpp); with
// its own rounding the sum with the middle is one step outward.
Aabb bounds_of_core(const Shape& shape, const Pose& pose, double deviation) {
  const Eigen::Vector3d middle = middle_of(shape, pose);
  const narrowphase::Core core = core_of(shape, pose, middle);
  const double pad = core.kind == narrowphase::CoreKind::Point
                         ? 0
                         : 0x20p-53 * (core.bounding_radius + core.radius);
  const double room =
      (kDistanceShare + kReadings * deviation) * (core.bounding_radius + core.radius);
  Aabb box;
  for (int i = 0; i < 3; ++i) {
    narrowphase::Vec3 axis{i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
    const double high = dot(rounded_support(core, axis), axis) + pad;
    const double low = dot(rounded_support(core, -axis), axis) - pad;
    box.max.data()[i] = above(middle.data()[i] + above(high));
    box.min.data()[i] = below(middle.data()[i] + below(low));
    give_room(box, i, room);
  }
  return box;
}

Aabb bounds_of_half_space(const HalfSpace& half_space, const Pose& pose) {
  const PlacedHalfSpace placed = placed_half_space(half_space, pose, Eigen::Vector3d::Zero());
  Aabb box{Eigen::Vector3d::Constant(-kLargest), Eigen::Vector3d::Constant(kLargest)};
  const double normal[3] = {placed.normal.x, placed.normal.y, placed.normal.z};
  for (int i = 0; i < 3; ++i) {
    if (normal[(i + 1) % 3] != 0 || normal[(i + 2) % 3] != 0) continue;
    const double bound = above(placed.offset + 8 * placed.slack);
    if (normal[i] > 0) box.max.data()[i] = bound;
    if (normal[i] < 0) box.min.data()[i] = -bound;
  }
  return box;
}

/// Returns the box of the points that are in the boxes of both of its half-spaces.
Aabb bounds_of_plane(const graze::Plane& plane, const Pose& pose) {
  const Aabb front = bounds_of_half_space(front_of(plane), pose);
  const Aabb back = bounds_of_half_space(back_of(plane), pose);
  return {front.min.cwiseMax(back.min), front.max.cwiseMin(back.max)};
}

// A placed coordinate is a sum of four terms with at most 4 roundings of what largest_coordinates()
// bounds.
Aabb bounds_of_mesh(const Aabb& own, const Pose& pose) {
  const std::array<double, 3> largest = largest_coordinates(pose, own);
  const double* m = pose.data();  // column-major 4x4
  Aabb box;
  for (int i = 0; i < 3; ++i) {
    double low = m[12 + i];
    double high = m[12 + i];
    for (int j = 0; j < 3; ++j) {
      const double at_min = m[4 * j + i] * own.min.data()[j];
      const double at_max = m[4 * j + i] * own.max.data()[j];
      low += std::min(at_min, at_max);
      high += std::max(at_min, at_max);
    }
    const double pad = 0x10p-53 * largest[i];
    box.min.data()[i] = below(low - pad);
    box.max.data()[i] = above(high + pad);
    give_room(box, i, kDistanceShare * largest[i]);
  }
  return box;
}

}  // namespace

double check_pose(const Pose& pose, const char* what) {
  return bvh::in_standard_arithmetic([&]() -> double {
    const double deviation = bvh::check_rigid(pose, what);
    for (int i = 0; i < 3; ++i) {
      if (std::abs(pose.data()[12 + i]) <= kLargestLength) continue;
      throw PoseError(std::string(what) + ": coordinate " + "xyz"[i] +
                      " of the translation is beyond the largest length");
    }
    return deviation;
  });
}

Aabb bounding_aabb(const PlacedShapeView& placed) {
  return bvh::in_standard_arithmetic([&]() -> Aabb {
    const Shape& shape = placed.shape;
    const Pose& pose = placed.pose;
    const double deviation = check_pose(pose, "pose");
    if (const auto* half_space = shape.as<HalfSpace>())
      return bounds_of_half_space(*half_space, pose);
    if (const auto* plane = shape.as<graze::Plane>()) return bounds_of_plane(*plane, pose);
    if (const auto* mesh = shape.as<Mesh>()) return bounds_of_mesh(mesh->bounds(), pose);
    if (const auto* field = shape.as<HeightField>()) return bounds_of_mesh(field->bounds(), pose);
    if (const auto* box = shape.as<Box>()) return bounds_of_box(*box, pose, deviation);
    return bounds_of_core(shape, pose, deviation);
  });
}

// A positive difference of doubles is at least the least double, so that rounding down stops there.
BoxGap gap_between(const Aabb& a, const Aabb& b) {
  return bvh::in_standard_arithmetic([&]() -> BoxGap {
    BoxGap most;
    for (int i = 0; i < 3; ++i) {
      const double after = b.min.data()[i] - a.max.data()[i];
      const double before = a.min.data()[i] - b.max.data()[i];
      const double gap = std::max(after, before);
      if (!(gap > 0)) continue;
      const double sure = std::max(below(gap), std::numeric_limits<double>::denorm_min());
      if (sure > most.gap) most = {sure, i, after > before};
    }
    return most;
  });
}

}  // namespace graze

#pragma once

// Makes cores of placed shapes, which the solvers of narrowphase/convex take. Private to
// engine/world.

#include <graze/bvh/obb.h>
#include <graze/bvh/pose.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/shape.h>
#include <graze/narrowphase/convex/core/core.h>
#include <graze/narrowphase/triangle.h>

namespace graze {

static inline narrowphase::Vec3 to_vec3(const Eigen::Vector3d& v) {
  return {v.data()[0], v.data()[1], v.data()[2]};
}
static inline Eigen::Vector3d to_eigen(const narrowphase::Vec3& v) {
  return {v.x, v.y, v.z};
}

/// Returns a point relative to `origin` in the world's frame.
static inline Eigen::Vector3d in_world(const narrowphase::Vec3& point,
                                       const Eigen::Vector3d& origin) {
  return to_eigen(point + to_vec3(origin));
}

/// Returns a placed box.
static inline Obb placed_box(const PlacedShapeView& s) {
  return {s.pose, s.shape.as<Box>()->half_extents};
}

/// Returns the shape's middle in the world, the origin to which cores of a pair are relative.
Eigen::Vector3d middle_of(const Shape& shape, const Pose& pose);

/// Returns the core of a convex shape in a pose, in the frame with the world's axes and that
/// origin. The shape must outlive it, and be convex: is_convex_core().
narrowphase::Core core_of(const Shape& shape, const Pose& pose, const Eigen::Vector3d& origin);

/// Returns the core of a placed triangle in such a frame.
narrowphase::Core core_of(const Triangle& placed, const Eigen::Vector3d& origin);

/// A half-space in that frame: the points x with normal . x <= offset.
struct PlacedHalfSpace {
  narrowphase::Vec3 normal;  ///< the normal, turned by the pose
  double offset;
  double slack;  ///< the most by which the offset is off
};
PlacedHalfSpace placed_half_space(const HalfSpace& half_space, const Pose& pose,
                                  const Eigen::Vector3d& origin);

/// False for half-spaces, planes, meshes and height fields.
bool is_convex_core(ShapeKind kind);

}  // namespace graze

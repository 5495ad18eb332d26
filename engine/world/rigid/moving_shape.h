#pragma once

#include <graze/bvh/aabb.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/shape.h>

namespace graze {

double length_of(const Eigen::Vector3d& v);

/// A shape in motion, with bounds of how far it moves.
struct MovingShape {
  /// A factor for the rounding of sums of lengths, and for the deviation of poses from rotations,
  /// 1e-6.
  static constexpr double kStretch = 1 + 0x1p-18;

  const Shape& shape;
  const RigidMotion& motion;
  double turned;   ///< the angle of the motion, radians, at least 0
  double lengths;  ///< the sum of all lengths that shape and motion are made of, metres
  /// No point is further than this from the centre of the motion, metres; 0 for endless shapes.
  double radius = 0;
  /// No point that turning moves is further than this from that centre, metres: of a ball its
  /// centre, of a capsule its segment.
  double turning_radius = 0;

  /// Takes a shape and a motion, which must outlive it. Throws PoseError, whose what() begins with
  /// `what`.
  MovingShape(const Shape& of_shape, const RigidMotion& in_motion, const char* what);

  bool is_half_space() const { return shape.kind() == ShapeKind::HalfSpace; }
  /// True for half-spaces and planes.
  bool is_endless() const { return is_half_space() || shape.kind() == ShapeKind::Plane; }
  bool is_mesh() const { return shape.kind() == ShapeKind::Mesh; }
  PlacedShape at(double t) const { return {shape, motion.at(t)}; }
};

/// Returns first_contact() of two shapes, by settings that were checked.
RigidContact contact_of_moving(const MovingShape& a, const MovingShape& b,
                               const RigidContactSettings& settings, Work& work);

/// Returns the same of two shapes in motion, by settings that it checks. The thread computes in
/// standard arithmetic.
RigidContact first_contact_of_shapes(const Shape& shape_a, const RigidMotion& motion_a,
                                     const Shape& shape_b, const RigidMotion& motion_b,
                                     const RigidContactSettings& settings, Work* work);

/// Returns a box that holds the shape at every t; for half-spaces and planes it reaches to the
/// largest doubles.
Aabb swept_bounds(const MovingShape& moving);

}  // namespace graze

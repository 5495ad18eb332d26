#pragma once

#include <graze/bvh/aabb.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/shape.h>

namespace graze {

double length_of(const Eigen::Vector3d& v);

/// A shape in motion, with what bounds how far it gets.
struct MovingShape {
  /// What lengths that are added up here round, and what poses deviate from rotations by, 1e-6.
  static constexpr double kStretch = 1 + 0x1p-18;

  const Shape& shape;
  const RigidMotion& motion;
  double turned;   ///< the angle of the motion, radians, at least 0
  double lengths;  ///< all that shape and motion are made of, added up, metres
  /// No point is further from the centre of the motion; 0 of what has no end.
  double radius = 0;
  /// Likewise no point of what turning moves: of a ball its centre, of a capsule its segment.
  double turning_radius = 0;

  /// Both must outlive it. Throws PoseError, which begins with `what`.
  MovingShape(const Shape& of_shape, const RigidMotion& in_motion, const char* what);

  bool is_half_space() const { return shape.kind() == ShapeKind::HalfSpace; }
  /// Half-spaces and planes.
  bool is_endless() const { return is_half_space() || shape.kind() == ShapeKind::Plane; }
  bool is_mesh() const { return shape.kind() == ShapeKind::Mesh; }
  PlacedShape at(double t) const { return {shape, motion.at(t)}; }
};

/// first_contact() of two shapes, by settings that were checked.
RigidContact contact_of_moving(const MovingShape& a, const MovingShape& b,
                               const RigidContactSettings& settings, Work& work);

/// A box that holds the shape at every t; for half-spaces and planes all that there is.
Aabb swept_bounds(const MovingShape& moving);

}  // namespace graze

#pragma once

// These are the door of motions (laws 10 and 14). They are private to engine/mesh/rigid.

#include <graze/bvh/aabb.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>

namespace graze {

/// Throws PoseError, which begins with `what`, for a pose that no motion starts from.
void check_start(const Pose& pose, const char* what);

/// Throw InputError for numbers that are not finite, and for an angle above kMostTurned.
void check_finite(const Eigen::Vector3d& vector, const char* what);
void check_angle(double angle);

/// Returns the axis with a length of 1. Throws InputError.
Eigen::Vector3d unit_axis(const Eigen::Vector3d& axis);

/// Throws InputError for a clearance or a tolerance that is no distance; returns the settings.
const RigidContactSettings& check_settings(const RigidContactSettings& settings);

/// Returns all lengths that a motion is made of, added up, metres: no coordinate of the body's
/// origin is larger at any t. The distance of a centre counts as far as turning about it moves
/// something.
double sum_of_lengths(const RigidMotion& motion);

/// Throws PoseError if the body's origin could overflow.
void check_coordinates(const RigidMotion& motion);

/// Throws PoseError, which begins with `what`, if a point of the body, within `bounds`, could
/// overflow, or a product of two coordinates.
void check_coordinates(const RigidMotion& motion, const Aabb& bounds, const char* what);

}  // namespace graze

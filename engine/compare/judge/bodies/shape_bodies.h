#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

#include <optional>

namespace graze::compare {

// These functions say what shapes are, by definitions that share nothing with the library's
// solvers. They compute in double, off by some ulp of the largest coordinate that takes part.

/// Returns a half-space itself, the one below the normal of a plane, and nothing for any other
/// shape.
std::optional<HalfSpace> flat_of(const Shape& shape);

/// Returns the largest n . x over the placed shape, for a unit n; for a mesh over its vertices. It
/// is infinite for a half-space in all directions but its own, to 1e-7, and for a plane in all but
/// its two.
double support_along(const Shape& shape, const Pose& pose, const Eigen::Vector3d& n);

/// Returns how far a point is outside of the placed shape, at about its surface: at least this for
/// a hull and a box, at most this for an ellipsoid; negative inside. For meshes and planes, which
/// are surfaces, it is the distance.
double outside_by(const Shape& shape, const Pose& pose, const Eigen::Vector3d& point);

}  // namespace graze::compare

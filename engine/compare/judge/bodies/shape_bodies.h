#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

#include <optional>

namespace graze::compare {

// What shapes are, by definitions that share nothing with the library's solvers. In double, off by
// some ulp of the largest coordinate that takes part.

/// A half-space itself, of a plane the one below its normal, and nothing of any other shape.
std::optional<HalfSpace> flat_of(const Shape& shape);

/// The largest n . x over the placed shape, for a unit n; of a mesh over its vertices. Infinite for
/// a half-space in all directions but its own, to 1e-7, and for a plane in all but its two.
double support_along(const Shape& shape, const Pose& pose, const Eigen::Vector3d& n);

/// How far a point is outside of the placed shape, at about its surface: at least this for a hull
/// and a box, at most this for an ellipsoid. Negative inside. Of meshes and
/// planes, which are surfaces, the distance.
double outside_by(const Shape& shape, const Pose& pose, const Eigen::Vector3d& point);

}  // namespace graze::compare

#pragma once

// Shapes at random, and what they are by definitions that share nothing with the library's solvers.

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

#include "tests/shapes/random_source.h"

namespace graze::tests {

/// A shape of about the size, metres, each length within a factor of 4 of it.
Shape random_shape(ShapeKind kind, double size, RandomSource& source);

/// How far outside the placed shape the point is, about: 0 on the surface, 0 or less inside, and
/// near the surface the distance to it, or less where that is at an edge.
double outside_by(const Shape& shape, const Pose& pose, const Eigen::Vector3d& point);

/// The largest n . x over the placed shape, for a unit n. Infinite for most of a half-space.
double reach_along(const Shape& shape, const Pose& pose, const Eigen::Vector3d& n);

/// The greatest distance of its points from its frame's origin; 1 for a half-space.
double size_of(const Shape& shape);

}  // namespace graze::tests

#pragma once

#include <optional>
#include <vector>

#include <graze/engine/world/shape.h>

namespace graze::compare {

// Hulls and half-spaces round when they are built: built again from what they say of themselves,
// they may be others by an ulp, and an engine that was given those would be blamed for it.

/// Returns points whose hull has the corners of this one, bit for bit, if any are found.
std::optional<std::vector<Eigen::Vector3d>> points_of(const ConvexHull& hull);

/// Returns a half-space that Shape makes this one of, bit for bit, if any is found.
std::optional<HalfSpace> source_of(const HalfSpace& half_space);

}  // namespace graze::compare

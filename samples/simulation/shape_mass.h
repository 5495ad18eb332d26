#pragma once

#include <graze/engine/world/shape.h>

#include "samples/simulation/mass_properties.h"

namespace graze::samples {

/// Returns the mass properties of a solid of one density, in the shape's own frame: by formulas,
/// for a hull and a mesh by the sum over its surface. Throws InputError for a half-space, which has
/// no mass, and as mass_properties() of a mesh does.
MassProperties mass_properties(const Shape& shape, double kilograms_per_cubic_metre);

/// Returns the greatest distance of the shape's points from one, metres, or somewhat more: that of
/// its corners, or of those of a box around it. Throws InputError for a half-space.
double bounding_radius_about(const Shape& shape, const Eigen::Vector3d& point);

}  // namespace graze::samples

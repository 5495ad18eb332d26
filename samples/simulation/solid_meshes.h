#pragma once

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/world/shape.h>

#include <array>
#include <span>

namespace graze::samples {

/// Says how fine the mesh of a round or of a large shape is.
struct Fineness {
  int sectors = 24;  ///< sectors around the axis
  int rings = 12;    ///< rings of a ball from pole to pole; half a ball has half as many
  int cells = 1;     ///< squares along each edge of a box: so many by so many on each side
};

/// Returns a closed mesh of the shape's surface; corners lie on it. A round shape is a prism of so
/// many sectors, of which a flat strip, not an edge, faces -x, so that it can lie on it. Throws
/// InputError for a half-space, which has no closed surface, and for a mesh, which is one.
Mesh surface_of(const Shape& shape, const Fineness& fineness = {});

/// Returns the body that a profile in the plane of x and z, counter-clockwise, sweeps from y =
/// -half_width to half_width. The fan from the profile's first point must cover it.
Mesh extruded(std::span<const std::array<double, 2>> profile, double half_width);

}  // namespace graze::samples

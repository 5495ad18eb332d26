#pragma once

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/world/shape.h>

#include <array>
#include <span>

namespace graze::samples {

/// How fine the mesh of a round or of a large shape is.
struct Fineness {
  int sectors = 24;  ///< around the axis
  int rings = 12;    ///< of a ball from pole to pole; of half a ball half as many
  int cells = 1;     ///< along each edge of a box: so many by so many squares on each side
};

/// A closed mesh of the shape's surface; corners lie on it. What is round is a prism of so many
/// sectors, of which a flat strip, not an edge, faces -x, so that it can lie on it. Throws
/// InputError for a half-space, which has no closed surface, and for a mesh, which is one.
Mesh surface_of(const Shape& shape, const Fineness& fineness = {});

/// A profile in the plane of x and z, counter-clockwise, drawn from y = -half_width to half_width.
/// It must be such that the fan from its first point covers it.
Mesh extruded(std::span<const std::array<double, 2>> profile, double half_width);

}  // namespace graze::samples

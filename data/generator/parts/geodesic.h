#pragma once

#include "data/generator/surface.h"

namespace graze::generator {

/// The unit sphere as 20 * frequency^2 triangles: each face of a regular icosahedron is divided
/// into frequency^2 and moved out to the sphere. Made with square roots: the same on every machine.
Surface make_geodesic_sphere(int frequency);

}  // namespace graze::generator

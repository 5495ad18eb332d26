#pragma once

// Meshes made by formula, for tests that must not depend on files.

#include <graze/engine/mesh/mesh.h>
#include <Eigen/Core>

namespace graze::tests {

/// A box around the origin, 12 triangles. Its corners are exact for extents that are powers of two.
Mesh make_box(const Eigen::Vector3d& half_extents);

/// A sphere around the origin of `rings` circles of `sectors` vertices and two poles.
Mesh make_sphere(double radius, int rings, int sectors);

/// A torus around the z axis.
Mesh make_torus(double radius, double tube_radius, int sectors, int tube_sectors);

/// `count` triangles of one metre in planes z = 0, each 10 metres from the last along x.
Mesh make_row(int count);

}  // namespace graze::tests

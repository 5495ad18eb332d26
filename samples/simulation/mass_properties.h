#pragma once

#include <graze/engine/mesh/mesh.h>

namespace graze::samples {

/// Holds the mass properties of a solid of one density, in the mesh's own frame.
struct MassProperties {
  double mass;              ///< kg
  Eigen::Vector3d centre;   ///< the centre of mass, metres
  Eigen::Matrix3d inertia;  ///< the inertia about the centre, kg m^2
  Eigen::Matrix3d inverse_inertia;
};

/// Sums over the tetrahedra between the origin and the triangles, signed by their sense. The mesh
/// must be closed and turn outwards: throws InputError if its volume is not positive.
MassProperties mass_properties(const Mesh& mesh, double kilograms_per_cubic_metre);

}  // namespace graze::samples

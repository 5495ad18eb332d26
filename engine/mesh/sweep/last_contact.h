#pragma once

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>

namespace graze::contacts {

/// Returns the direction with length 1, to 2 ulp; exactly what it was, for axes. Throws InputError
/// for one that is zero or not finite.
Eigen::Vector3d unit_direction(const Eigen::Vector3d& direction);

/// Returns the largest translation of B along the unit vector, metres, at which the meshes can
/// still meet; 0 if there is none. If it is `limit` or more, any value that is may be returned.
/// Both must be placed soundly.
double last_contact(const PlacedMeshView& a, const PlacedMeshView& b,
                    const Eigen::Vector3d& direction, double limit, Work& work);

}  // namespace graze::contacts

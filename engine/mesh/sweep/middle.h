#pragma once

#include <graze/engine/mesh/placed_mesh.h>

namespace graze::contacts {

/// The middle of the mesh's own bounds, placed.
Eigen::Vector3d middle_of(const PlacedMeshView& placed);

}  // namespace graze::contacts

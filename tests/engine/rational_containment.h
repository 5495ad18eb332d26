#pragma once

#include <graze/engine/mesh/mesh.h>

namespace graze::oracle {

/// Whether the point lies on the mesh or is enclosed by it (even-odd), in rationals: crossings of a
/// slanted ray that meets no edge, found by trying directions.
bool contains_by_slanted_ray(const Mesh& mesh, const Eigen::Vector3d& point);

}  // namespace graze::oracle

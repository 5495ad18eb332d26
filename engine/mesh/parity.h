#pragma once

// The even-odd rule behind containment.h and the solid voxels. Private to engine/mesh.

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/work.h>

namespace graze {

/// Throws MeshError, with the number of boundary edges, unless the mesh is closed.
void check_closed(const Mesh& mesh);

/// Whether the point moved by (e, e^2, e^3), e > 0 and small, is enclosed by a closed mesh; see
/// narrowphase/axis_line.h. A point that lies on no triangle is enclosed if and only if this point
/// beside it is. `point` must lie within the mesh's bounds.
bool is_moved_point_enclosed(const Mesh& mesh, const Eigen::Vector3d& point, Work& work);

}  // namespace graze

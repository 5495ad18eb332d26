#pragma once

// The even-odd rule behind containment.h, Interior::Solid and the solid voxels. Private to
// the library. "The moved point" is the point moved by (e, e^2, e^3), e > 0 and small; see
// narrowphase/ray/axis_line.h. A point that lies on no triangle is enclosed if and only if the
// moved point beside it is.

#include <graze/bvh/obb.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/ray/face_sample.h>
#include <graze/narrowphase/ray/rational_sample.h>

#include <cstdint>
#include <string>
#include <vector>

namespace graze {

/// Throws InputError, which begins with `what`, for a point that is not finite.
void check_point(const Eigen::Vector3d& point, const std::string& what);

/// Throws MeshError, which begins with `what`, with the number of boundary edges and the first of
/// them, unless the mesh is closed.
void check_closed(const Mesh& mesh, const char* what);

/// Whether the moved point is enclosed by a closed mesh. `point` must lie within the mesh's bounds.
bool is_moved_point_enclosed(const Mesh& mesh, const Eigen::Vector3d& point, Work& work);

/// Whether the point lies on a placed triangle of a closed mesh (law 1) or is enclosed by them, in
/// one walk. Exact. For the identity `point` must lie within the mesh's bounds.
bool is_on_or_enclosed(const Mesh& mesh, const Eigen::Vector3d& point, Work& work);
bool is_on_or_enclosed(const PlacedMeshView& placed, const Eigen::Vector3d& point, Work& work);

/// The triangles of any mesh that one ray of a point beside one of them, along an axis, crosses: of
/// each closed part that encloses it an odd number.
void crossed_triangles(const Mesh& mesh, const narrowphase::FaceSample& sample, Work& work,
                       std::vector<std::uint32_t>& triangles);

/// Whether the moved point is enclosed by the placed triangles of a closed mesh (law 1), wherever
/// it lies. Exact. Placing keeps a mesh closed: equal vertices are placed alike.
bool is_moved_point_enclosed(const PlacedMeshView& placed, const Eigen::Vector3d& point,
                             Work& work);

/// Whether a point that is as near to a placed triangle as can be, of this mesh or of another, is
/// enclosed by the placed triangles of a closed mesh. Exact.
bool is_sample_enclosed(const PlacedMeshView& placed, const narrowphase::FaceSample& sample,
                        Work& work);
bool is_sample_enclosed(const PlacedMeshView& placed, const narrowphase::RationalSample& sample,
                        Work& work);

/// Whether the moved origin of the box's frame is enclosed by the triangles that law 3 takes into
/// that frame. Exact. No vertex may overflow on its way.
bool is_moved_centre_enclosed(const PlacedMeshView& placed, const Obb& box, Work& work);

}  // namespace graze

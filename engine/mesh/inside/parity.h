#pragma once

// This is the even-odd rule behind containment.h, Interior::Solid and the solid voxels. It is
// private to the library. "The moved point" is the point moved by (e, e^2, e^3), e > 0 and small;
// see narrowphase/ray/axis_line.h. A point that lies on no triangle is enclosed if and only if the
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

/// True if the moved point is enclosed by a closed mesh. `point` must lie within the mesh's bounds.
bool is_moved_point_enclosed(const Mesh& mesh, const Eigen::Vector3d& point, Work& work);

/// True if the point lies on a placed triangle of a closed mesh (law 1) or is enclosed by them. It
/// is decided exactly, in one walk. For the identity `point` must lie within the mesh's bounds.
bool is_on_or_enclosed(const Mesh& mesh, const Eigen::Vector3d& point, Work& work);
bool is_on_or_enclosed(const PlacedMeshView& placed, const Eigen::Vector3d& point, Work& work);

/// Finds the triangles of any mesh that one ray along an axis crosses, from a point beside one of
/// them: of each closed part that encloses the point an odd number.
void crossed_triangles(const Mesh& mesh, const narrowphase::FaceSample& sample, Work& work,
                       std::vector<std::uint32_t>& triangles);

/// True if the moved point is enclosed by the placed triangles of a closed mesh (law 1), wherever
/// it lies. The answer is exact. Placing keeps a mesh closed: equal vertices are placed alike.
bool is_moved_point_enclosed(const PlacedMeshView& placed, const Eigen::Vector3d& point,
                             Work& work);

/// True if a point that is as near to a placed triangle as can be, of this mesh or of another, is
/// enclosed by the placed triangles of a closed mesh. The answer is exact.
bool is_sample_enclosed(const PlacedMeshView& placed, const narrowphase::FaceSample& sample,
                        Work& work);
bool is_sample_enclosed(const PlacedMeshView& placed, const narrowphase::RationalSample& sample,
                        Work& work);

/// True if the moved origin of the box's frame is enclosed by the triangles that law 3 takes into
/// that frame. The answer is exact. No vertex may overflow on its way.
bool is_moved_centre_enclosed(const PlacedMeshView& placed, const Obb& box, Work& work);

}  // namespace graze

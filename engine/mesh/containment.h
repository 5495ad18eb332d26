#pragma once

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/work.h>
#include <Eigen/Core>

namespace graze {

/// True if and only if the point, in the mesh's own frame and metres, lies on the surface or is
/// enclosed by it. Enclosed is meant by the even-odd rule: a path to infinity that meets no edge
/// goes through the surface an odd number of times, so that neither the triangles' orientation nor
/// their order matters, a cavity is outside, and what two bodies of one mesh both enclose is
/// outside. Exact for every finite mesh and point. About O(log n) for compact meshes; the first
/// call computes the topology and the tree.
/// Throws MeshError, with the number of boundary edges, if the mesh is not closed, and InputError
/// for a point that is not finite.
bool contains(const Mesh& mesh, const Eigen::Vector3d& point, Work* work = nullptr);

}  // namespace graze

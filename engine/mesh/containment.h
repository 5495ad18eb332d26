#pragma once

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/mesh/query_settings.h>
#include <graze/engine/work.h>
#include <Eigen/Core>

#include <span>
#include <vector>

namespace graze {

/// True if and only if the point, metres, lies on the placed mesh's surface (law 1) or is enclosed
/// by it. What is enclosed is said by the even-odd rule: a path to infinity that meets no edge goes
/// through the surface an odd number of times, so that neither the triangles' orientation nor their
/// order matters, a cavity is outside, and what two bodies of one mesh both enclose is outside. The
/// answer is exact for every finite mesh and point. It takes about O(log n) for compact meshes; the
/// first call computes the topology and the tree. Throws MeshError, with the number of boundary
/// edges, if the mesh is not closed, InputError for a point that is not finite, and PoseError for a
/// pose that is refused by law 10 or by law 1.
bool contains(const PlacedMeshView& mesh, const Eigen::Vector3d& point, Work* work = nullptr);

/// Answers contains() for each of many points, which threads share: the same answers bit for bit,
/// in the points' order. The points are a span, or the rows of a matrix of three columns in any
/// storage order. Throws as contains() does, before the first answer, and names the point by its
/// index; throws InputError for another number of columns.
std::vector<bool> contains_points(const PlacedMeshView& mesh,
                                  std::span<const Eigen::Vector3d> points,
                                  const BatchSettings& batch = {}, Work* work = nullptr);
std::vector<bool> contains_points(const PlacedMeshView& mesh, const MatrixView<double>& points,
                                  const BatchSettings& batch = {}, Work* work = nullptr);

}  // namespace graze

#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/pair.h>

#include <cstddef>
#include <vector>

namespace graze::benchmark {

/// What is true of two meshes in a pose.
struct MeshTruth {
  std::size_t candidates = 0;       ///< pairs of triangles whose boxes share a point
  std::vector<TrianglePair> pairs;  ///< of these, those that intersect, ascending
};

/// By sweeping along an axis, without any tree, and the exact referee for each candidate. Triangles
/// are placed by law 1.
MeshTruth truth_of(const Mesh& mesh_a, const Mesh& mesh_b, const Pose& pose_b);

}  // namespace graze::benchmark

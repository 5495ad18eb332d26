#pragma once

#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>

#include <span>
#include <utility>
#include <vector>

namespace graze {

/// A mesh in each of many poses, as the second argument of queries: `intersects({bolt}, {nut,
/// poses})`. It refers to the poses, which must outlive it.
struct MeshInPoses {
  /// Refers to the poses.
  MeshInPoses(Mesh mesh_b, std::span<const Pose> poses_b)
      : mesh(std::move(mesh_b)), poses(poses_b) {}

  Mesh mesh;                    ///< a handle
  std::span<const Pose> poses;  ///< must outlive this
};

/// These answer the queries of pair.h and distance.h for each pose of B, in the order of the poses.
/// `settings` are those of each single query. They throw as the single queries do, before the first
/// answer where a pose is to blame, which the error names by its index. What has to be built is
/// built once; other threads wait for it.
std::vector<bool> intersects(const PlacedMeshView& mesh_a, const MeshInPoses& mesh_b,
                             const QuerySettings& settings = {}, const BatchSettings& batch = {},
                             Work* work = nullptr);
std::vector<TrianglePairs> find_triangle_pairs(const PlacedMeshView& mesh_a,
                                               const MeshInPoses& mesh_b,
                                               const PairSettings& settings = {},
                                               const BatchSettings& batch = {},
                                               Work* work = nullptr);
std::vector<bool> interiors_intersect(const PlacedMeshView& mesh_a, const MeshInPoses& mesh_b,
                                      const BatchSettings& batch = {}, Work* work = nullptr);
std::vector<bool> within(const PlacedMeshView& mesh_a, const MeshInPoses& mesh_b, double clearance,
                         const DistanceSettings& settings = {}, const BatchSettings& batch = {},
                         Work* work = nullptr);
std::vector<MeshDistance> distance(const PlacedMeshView& mesh_a, const MeshInPoses& mesh_b,
                                   const DistanceSettings& settings = {},
                                   const BatchSettings& batch = {}, Work* work = nullptr);

}  // namespace graze

#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>
#include <cstddef>
#include <vector>

namespace graze::tests {

/// What a cross-check met, so that tests can demand that it looked at hard cases.
struct CrossCheckCounts {
  std::size_t intersecting = 0;  ///< poses
  std::size_t apart = 0;         ///< poses
  std::size_t pairs = 0;         ///< of triangles, found by graze
  std::size_t differences = 0;   ///< pairs that one engine only reports
};

/// Puts both queries to graze and FCL for every pose of B, and expects graze to be right by the
/// referee wherever they differ.
CrossCheckCounts cross_check(const Mesh& mesh_a, const Mesh& mesh_b,
                             const std::vector<Pose>& poses);

}  // namespace graze::tests

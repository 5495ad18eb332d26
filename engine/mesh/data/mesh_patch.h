#pragma once

// A part of a surface that is nowhere kept as a mesh. Private to the library.

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/mesh.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace graze {

/// Some triangles of a whole, with all their vertices.
struct MeshPatch {
  std::vector<Eigen::Vector3d> vertices;  ///< in positions of their own each
  std::vector<TriangleIndices> triangles;
  Aabb bounds;                                  ///< of the whole
  std::vector<std::uint32_t> vertex_numbers;    ///< in the whole, ascending
  std::vector<std::uint32_t> triangle_numbers;  ///< likewise
  /// Of each vertex, whether the whole goes on where the patch ends; empty if that matters to
  /// nobody.
  std::vector<std::uint8_t> is_rim = {};
  /// Over the triangles, in the frame around the bounds, if there is one at hand: else it is built
  /// as of any mesh, by the query that asks for it.
  std::optional<bvh::Tree> tree = {};
};

/// The patch as a mesh that says what the whole would, bit for bit, wherever its triangles decide:
/// its bounds, and so its frame and all slack, are the whole's, and numbers ascend as there.
/// Nothing is checked.
Mesh mesh_of(MeshPatch&& patch);

/// What vertices and triangles are called in features of contacts: of a patch by their numbers in
/// the whole.
struct MeshNumbers {
  std::span<const std::uint32_t> vertices;
  std::span<const std::uint32_t> triangles;

  std::uint32_t vertex(std::uint32_t index) const {
    return vertices.empty() ? index : vertices[index];
  }
  std::uint32_t triangle(std::uint32_t index) const {
    return triangles.empty() ? index : triangles[index];
  }
};
/// Valid as long as a handle.
MeshNumbers numbers_of(const Mesh& mesh);

/// MeshPatch::is_rim; empty of what is no patch. Valid as long.
std::span<const std::uint8_t> rim_of(const Mesh& mesh);

}  // namespace graze

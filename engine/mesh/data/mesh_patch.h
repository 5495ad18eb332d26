#pragma once

// This is a part of a surface that is nowhere kept as a mesh. It is private to the library.

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/mesh.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace graze {

/// Some triangles of a whole, with all their vertices.
struct MeshPatch {
  std::vector<Eigen::Vector3d> vertices;  ///< the vertices, each in a position of its own
  std::vector<TriangleIndices> triangles;
  Aabb bounds;                                  ///< the bounds of the whole
  std::vector<std::uint32_t> vertex_numbers;    ///< the vertices' numbers in the whole, ascending
  std::vector<std::uint32_t> triangle_numbers;  ///< the triangles' numbers in the whole, ascending
  /// For each vertex, whether the whole goes on where the patch ends; empty if that matters to
  /// nobody.
  std::vector<std::uint8_t> is_rim = {};
  /// The tree over the triangles, in the frame around the bounds, if there is one at hand.
  /// Otherwise the query that asks for it builds it, as for any mesh.
  std::optional<bvh::Tree> tree = {};
};

/// Returns the patch as a mesh that answers what the whole would, bit for bit, wherever its
/// triangles decide: its bounds, and so its frame and all slack, are the whole's, and numbers
/// ascend as there. Nothing is checked.
Mesh mesh_of(MeshPatch&& patch);

/// The numbers by which features of contacts name vertices and triangles: those of a patch are
/// their numbers in the whole.
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
/// Returns the numbers, which are valid as long as a handle is.
MeshNumbers numbers_of(const Mesh& mesh);

/// Returns MeshPatch::is_rim, valid as long as a handle is; empty if the mesh is no patch.
std::span<const std::uint8_t> rim_of(const Mesh& mesh);

}  // namespace graze

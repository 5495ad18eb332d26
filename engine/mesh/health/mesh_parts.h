#pragma once

// These are the parts of a surface that edges connect. They are private to the library.

#include <graze/engine/mesh/data/directed_edges.h>
#include <graze/engine/mesh/mesh.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze {

/// The triangles of a mesh, in parts that are connected across edges with two triangles: what meets
/// at an edge of more belongs together in no way that a mesh tells.
struct MeshParts {
  std::vector<std::uint32_t> part_of;    ///< the part of each triangle
  std::vector<std::uint32_t> first;      ///< for each part, and one more: its first in `triangles`
  std::vector<std::uint32_t> triangles;  ///< the triangles of each part, ascending
  /// For each part, whether as many of its triangles go along each edge one way as the other: then
  /// it is closed and consistently wound, and encloses a volume with a sign.
  std::vector<bool> is_oriented;
  /// For each part, whether that holds of its edges with two triangles: then it faces one side.
  std::vector<bool> is_consistent;
  /// The value of surface_of for a part that is of no closed surface. A part is a closed surface by
  /// itself if it is oriented. Parts that are not go together where they meet at an edge, and are
  /// closed if they have an even number of triangles at each; else they are of none.
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::vector<std::uint32_t> surface_of;  ///< the lowest part of each part's surface

  std::size_t size() const { return is_oriented.size(); }
  std::span<const std::uint32_t> triangles_of(std::uint32_t part) const {
    return {triangles.data() + first[part], first[part + 1] - first[part]};
  }
};

/// Finds the parts, in the order of their lowest triangles. It takes O(n) after
/// directed_edges_of().
MeshParts parts_of(const Mesh& mesh, std::span<const DirectedEdge> edges);

}  // namespace graze

#pragma once

#include <graze/engine/mesh/mesh.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze {

/// The triangles around each welded vertex.
struct VertexFans {
  std::vector<std::uint32_t> first;  ///< for each vertex, and one more: where its triangles begin
  std::vector<std::uint32_t> triangles;  ///< ascending for each vertex; those that repeat it, again

  /// Returns the triangles around a vertex; none for a vertex that is welded to one of lower index.
  std::span<const std::uint32_t> around(std::uint32_t vertex) const {
    return {triangles.data() + first[vertex], first[vertex + 1] - first[vertex]};
  }
};

/// Makes the fans by counting, in linear time.
VertexFans fans_of(std::span<const TriangleIndices> triangles,
                   std::span<const std::uint32_t> welded);

}  // namespace graze

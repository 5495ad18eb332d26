#pragma once

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/mesh_path.h>

#include <vector>

namespace graze {

/// Return the bits of what a triangle represents: corner k, and the edge from corner k to the next.
constexpr std::uint8_t corner_bit(std::uint32_t k) {
  return static_cast<std::uint8_t>(1u << k);
}
constexpr std::uint8_t edge_bit(std::uint32_t k) {
  return static_cast<std::uint8_t>(8u << k);
}

struct MeshPath::Data {
  Mesh start;
  Mesh end;
  bvh::Tree tree;  ///< the tree over what the triangles sweep
  Aabb bounds;     ///< the bounds of all that
  /// The corners and edges that each triangle represents, as bits: those that no earlier one has.
  std::vector<std::uint8_t> represented;
};

/// The way of queries to the data.
struct MeshPathAccess {
  static const MeshPath::Data& data(const MeshPath& path) { return *path.data_; }
  using Data = MeshPath::Data;
};

}  // namespace graze

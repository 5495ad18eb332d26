#pragma once

// Which crossings of a piece are on a triangle or end in a point. Private to engine/world.

#include <graze/engine/world/contacts/meshes/mesh_crossings.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze {

/// Numbers of crossings are those in the piece, whose crossings ascend by pair. Memory is kept from
/// one piece to the next.
class PieceIndex {
 public:
  /// They must outlive it.
  void start(std::span<const MeshCrossing> crossings);

  std::span<const MeshCrossing> crossings() const { return crossings_; }
  std::span<const std::uint32_t> on_triangle(std::uint32_t triangle, bool is_of_a) const;
  /// Points are numbered from that of the piece's first crossing on.
  std::span<const std::uint32_t> in_point(std::uint32_t point) const;

  std::uint32_t first_point() const { return crossings_.front().from_number; }
  std::size_t point_count() const { return first_in_point_.size() - 1; }

 private:
  std::span<const MeshCrossing> crossings_;
  std::vector<std::uint32_t> by_a_, by_b_;
  std::vector<std::uint32_t> in_points_;       ///< crossings, point by point
  std::vector<std::uint32_t> first_in_point_;  ///< for each point, and one more
};

}  // namespace graze

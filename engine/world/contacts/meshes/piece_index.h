#pragma once

// Finds the crossings of a piece that are on a triangle or end in a point. Private to engine/world.

#include <graze/engine/world/contacts/meshes/mesh_crossings.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze {

/// An index of the crossings of a piece, which must ascend by pair and are numbered within the
/// piece. Memory is kept from one piece to the next.
class PieceIndex {
 public:
  /// Indexes crossings, which must outlive it.
  void start(std::span<const MeshCrossing> crossings);

  std::span<const MeshCrossing> crossings() const { return crossings_; }
  std::span<const std::uint32_t> on_triangle(std::uint32_t triangle, bool is_of_a) const;
  /// Returns the crossings on the triangle of A or B of a crossing.
  std::span<const std::uint32_t> on_triangle_of(std::uint32_t crossing, bool is_of_a) const {
    const Order& order = orders_[is_of_a];
    const std::uint32_t first = order.first[crossing];
    return std::span(order.crossings).subspan(first, order.last[first] - first);
  }
  /// Returns the crossings that end in a point. Points are numbered from that of the piece's first
  /// crossing on.
  std::span<const std::uint32_t> in_point(std::uint32_t point) const;

  std::uint32_t first_point() const { return crossings_.front().from_number; }
  std::size_t point_count() const { return first_in_point_.size() - 1; }

 private:
  /// The crossings in the order of the triangles of one mesh.
  struct Order {
    std::vector<std::uint32_t> crossings;
    std::vector<std::uint32_t> first;  ///< for each crossing, where those of its triangle begin
    std::vector<std::uint32_t> last;   ///< the end of the crossings that begin at a place
  };
  std::uint32_t triangle_of(std::uint32_t crossing, bool is_of_a) const {
    return is_of_a ? crossings_[crossing].pair.a : crossings_[crossing].pair.b;
  }
  void find_runs(bool is_of_a);

  std::span<const MeshCrossing> crossings_;
  Order orders_[2];                            ///< the order by the triangles of B, and of A
  std::vector<std::uint32_t> in_points_;       ///< the crossings, point by point
  std::vector<std::uint32_t> first_in_point_;  ///< the first place in in_points_ for each point,
                                               ///< and the end
};

}  // namespace graze

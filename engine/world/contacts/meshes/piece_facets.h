#pragma once

// The triangles that cross in a piece that wraps around, by how deep they are met. Private to
// engine/world.

#include <graze/engine/world/contacts/meshes/inner_surface.h>
#include <graze/engine/world/contacts/meshes/piece_index.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze {

/// Memory is kept from one piece to the next.
class PieceFacets {
 public:
  struct Facet {
    double bound;  ///< how deep what goes through the triangle is behind its plane at least
    std::uint32_t triangle;
    bool is_of_a;
    std::uint32_t pairs_left = 0;  ///< crossings of it that are still to be parted
  };

  /// The crossings and both surfaces must outlive it. All crossings are to be parted.
  void start(std::span<const MeshCrossing> crossings, const InnerSurface& surface_a,
             const InnerSurface& surface_b);

  const PieceIndex& index() const { return index_; }
  /// Ascending by bound.
  std::span<const Facet> facets() const { return facets_; }

  /// Only these are to be parted: some of the crossings, in their order.
  void leave(std::span<const TrianglePair> pairs);
  /// Those of a facet are.
  void part(std::size_t facet);

 private:
  void find_facets(const InnerSurface& other, bool of_a);
  std::uint32_t& facet_of(std::uint32_t crossing, bool of_a) { return facet_of_[of_a][crossing]; }
  void set_left(std::uint32_t crossing, bool is_left);

  PieceIndex index_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> facet_of_[2];  ///< of each crossing, its triangles' facets
  std::vector<std::uint8_t> is_left_;       ///< of each crossing
  std::vector<double> lowest_;              ///< of a triangle's corners and curves, by crossings
};

}  // namespace graze

#pragma once

// Orders the triangles that cross in a piece that wraps around by how deep they are met. Private to
// engine/world.

#include <graze/engine/world/contacts/meshes/inner_surface.h>
#include <graze/engine/world/contacts/meshes/piece_index.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze {

/// The facets of a piece. Memory is kept from one piece to the next.
class PieceFacets {
 public:
  struct Facet {
    double bound;  ///< a lower bound of how deep the other surface is behind the triangle's plane
    std::uint32_t triangle;
    bool is_of_a;
    std::uint32_t pairs_left = 0;  ///< the number of its crossings that are still to be parted
  };

  /// Begins with a piece, all of whose crossings are to be parted. The crossings and both surfaces
  /// must outlive it.
  void start(std::span<const MeshCrossing> crossings, const InnerSurface& surface_a,
             const InnerSurface& surface_b);

  const PieceIndex& index() const { return index_; }
  /// Returns the facets, ascending by bound.
  std::span<const Facet> facets() const { return facets_; }

  /// Leaves only these pairs to be parted: some of the crossings, in their order.
  void leave(std::span<const TrianglePair> pairs);
  /// Marks the crossings of a facet as parted.
  void part(std::size_t facet);

 private:
  void find_facets(const InnerSurface& other, bool of_a);
  std::uint32_t& facet_of(std::uint32_t crossing, bool of_a) { return facet_of_[of_a][crossing]; }
  void set_left(std::uint32_t crossing, bool is_left);

  PieceIndex index_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> facet_of_[2];  ///< the facets of the triangles of each crossing
  std::vector<std::uint8_t> is_left_;       ///< whether each crossing is still to be parted
  std::vector<double> lowest_;              ///< the lowest height of a triangle's corners and
                                            ///< curves, by crossings
};

}  // namespace graze

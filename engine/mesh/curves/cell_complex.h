#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/bvh/volume.h>
#include <graze/engine/mesh/curves/feature_name.h>
#include <graze/engine/mesh/curves/placed_corners.h>
#include <graze/engine/mesh/pair.h>

namespace graze::contacts {

/// A corner of a cell.
struct Node {
  NodeName name;
  Eigen::Vector3d position;  ///< off by at most 2 ulp of the largest coordinate
};

/// A point, the segment between two nodes, or a convex polygon, and the pairs of triangles whose
/// intersection it is.
struct Cell {
  std::array<std::uint32_t, 6>
      corner{};  ///< the corners in cyclic order: the lowest node first, its lower neighbour next
  std::uint32_t count = 0;
  std::uint32_t first_pair = 0;
  std::uint32_t pair_count = 0;

  auto operator<=>(const Cell&) const = default;
};

/// The intersection of two placed meshes: what each pair of triangles has in common, where cells
/// that are equal by the names of their corners are joined. Nodes ascend by position, then by the
/// positions of what they are made of: an order that does not know which mesh is A (law 4). Each
/// list of cells ascends by corners.
struct CellComplex {
  PlacedCorners a;
  PlacedCorners b;
  std::vector<Node> nodes;
  std::vector<Cell> points;
  std::vector<Cell> segments;
  std::vector<Cell> polygons;
  std::vector<TrianglePair> pairs;  ///< the pairs of the cells, one after the other

  std::span<const TrianglePair> pairs_of(const Cell& cell) const {
    return {pairs.data() + cell.first_pair, cell.pair_count};
  }
};

CellComplex intersect_cells(const PlacedMeshView& a, const PlacedMeshView& b, PairVolume volume,
                            Work* work);

}  // namespace graze::contacts

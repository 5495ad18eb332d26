#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <graze/engine/mesh/curves/cell_complex.h>

namespace graze::contacts {

/// The unit normal of a placed triangle, on the side from which its corners turn counter-clockwise;
/// zero for one without area. Exactly along an axis where the triangle is in such a plane.
Eigen::Vector3d face_normal(const PlacedCorners& corners, std::uint32_t triangle);

/// What the triangles of a cell look like from either side.
struct CellNormals {
  Eigen::Vector3d sum_a{0, 0, 0};  ///< of the unit normals of its triangles of A, each once
  Eigen::Vector3d sum_b{0, 0, 0};
  int count_a = 0;
  int count_b = 0;
};

/// The sums go through the triangles of each mesh in ascending order, so that swapping the meshes
/// swaps the sums bit for bit.
CellNormals normals_of(const CellComplex& complex, const Cell& cell);

}  // namespace graze::contacts

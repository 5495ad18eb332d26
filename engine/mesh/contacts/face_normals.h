#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <graze/engine/mesh/curves/cell_complex.h>

namespace graze::contacts {

/// Returns the unit normal of a placed triangle, on the side from which its corners turn
/// counter-clockwise; zero for one without area. It is exactly along an axis where the triangle is
/// in such a plane.
Eigen::Vector3d face_normal(const PlacedCorners& corners, std::uint32_t triangle);

/// The normals that the triangles of a cell have together.
struct CellNormals {
  Eigen::Vector3d sum_a{0, 0, 0};  ///< the sum of the unit normals of its triangles of A, each once
  Eigen::Vector3d sum_b{0, 0, 0};
  int count_a = 0;
  int count_b = 0;
};

/// Returns the sums of the normals. They go through the triangles of each mesh in ascending order,
/// so that swapping the meshes swaps the sums bit for bit.
CellNormals normals_of(const CellComplex& complex, const Cell& cell);

}  // namespace graze::contacts

#pragma once

#include <cstdint>
#include <vector>

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/world/shape.h>

#include <Eigen/Core>

namespace graze::view {

/// Holds a surface for the eye.
struct Triangulation {
  std::vector<Eigen::Vector3d> vertices = {};   ///< the vertices, all of them used
  std::vector<TriangleIndices> triangles = {};  ///< the triangles, in the order of the mesh, if it
                                                ///< is one
  bool is_boundless = false;                    ///< true if it stands for a shape without an end

  bool operator==(const Triangulation&) const = default;
};

struct TriangulationSettings {
  std::uint32_t segments = 48;    ///< the number of segments of a circle
  double half_space_extent = 10;  ///< half the side of the square that stands for a plane, metres
};

/// Return any shape as triangles, which turn counter-clockwise as seen from outside. Those of a
/// mesh are the mesh's, each with its number.
Triangulation triangulate(const Shape& shape, const TriangulationSettings& settings);
Triangulation triangulate(const Mesh& mesh);

}  // namespace graze::view

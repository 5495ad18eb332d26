#pragma once

#include <cstdint>
#include <vector>

#include <graze/engine/mesh/curves/regions.h>

namespace graze::contacts {

/// One of the two meshes that meet, and the other one as it looks from there.
struct MeshSide {
  const PlacedMeshView& own_mesh;
  const PlacedCorners& own;
  const PlacedCorners& other;
  FeatureName NodeName::*own_name;
  FeatureName NodeName::*other_name;
};

/// The parts of a mesh's surface that lie inside the other and end at an intersection, as sets of
/// points: placed vertices, and the nodes at which their edges leave the other mesh.
struct InnerParts {
  std::vector<std::vector<Eigen::Vector3d>> parts;
  std::vector<std::vector<std::uint32_t>> of_region;  ///< for each region, which parts end at it
};

/// Finds the parts. From the nodes, whose triangles say which end of an edge lies behind the other
/// surface, parts are followed from vertex to vertex as far as no edge meets the other mesh;
/// stretches of edges from node to node that lie inside end at the regions of both. Inside is where
/// the triangles' counter-clockwise sides look away. A region with a loose end encloses nothing,
/// nor does one from which edges lead from the inside to the outside: of these, the next vertices
/// are all there is. It takes O(n) time for parts of n elements.
InnerParts find_inner_parts(const CellComplex& complex, const std::vector<Region>& regions,
                            const MeshSide& side);

}  // namespace graze::contacts

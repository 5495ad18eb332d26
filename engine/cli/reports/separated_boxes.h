#pragma once

#include <graze/engine/mesh/pair.h>

#include <cstddef>
#include <optional>
#include <string>

namespace graze::cli {

/// Describes an axis along which two placed boxes are compared.
struct BoxAxis {
  std::string name;           ///< "x of A", "x of A cross y of B"
  Eigen::Vector3d direction;  ///< a unit vector in the common frame
  double gap;                 ///< metres between the boxes along it; negative where they overlap
};

/// Returns the one of the fifteen axes of the boxes around two meshes along which these are
/// furthest apart.
BoxAxis widest_axis(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b);

/// Holds boxes of the two trees around a pair of triangles, and what is in them.
struct SeparatedBoxes {
  std::size_t triangles_a = 0;
  std::size_t triangles_b = 0;
  BoxAxis axis;
};

/// Returns the first boxes that are apart on the way from the roots down to the pair, where the
/// larger is opened first, and nothing if those of its leaves overlap. They are in double, for
/// people to read: a query's own boxes are wider by its slack (law 5), and those of wide trees are
/// others.
std::optional<SeparatedBoxes> separated_boxes(const PlacedMeshView& mesh_a,
                                              const PlacedMeshView& mesh_b, TrianglePair pair);

}  // namespace graze::cli

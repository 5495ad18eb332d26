#pragma once

// This is private to engine/mesh.

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/placing/relative_frame.h>
#include <graze/engine/mesh/query/wide_query.h>

#include <cstdint>
#include <optional>

namespace graze {

/// Looks for nearest points of one placed mesh, for any number of points.
class NearestSearch {
 public:
  /// Takes a mesh in a pose that has been checked, whose deviation from a rotation this is.
  NearestSearch(const PlacedMeshView& placed, double deviation, Work& work);

  /// Answers nearest_point() for a finite point. A triangle that may be near, such as the answer
  /// for a point beside it, saves time and changes no result.
  NearestPoint nearest_to(const Eigen::Vector3d& point, std::optional<std::uint32_t> hint);

 private:
  class Descent;

  const bvh::Tree& tree_;
  PlacedFrame frame_;
  PlacedTriangles triangles_;
  double largest_;
  Work& work_;
};

}  // namespace graze

#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <graze/engine/mesh/curves/placed_corners.h>

namespace graze::contacts {

enum class SurfaceSide { Inside, Outside, Unknown };

/// Tells on which side of a surface a segment leads that starts from a point on the surface.
class SurfaceSides {
 public:
  explicit SurfaceSides(const PlacedCorners& corners);

  /// Returns the side on which `point` lies, to which the segment leads. It is exact where
  /// `feature`, in which the segment starts, is a face, or an edge of two triangles with the same
  /// sense. It is Unknown at vertices, at other edges, and for segments that stay in the surface.
  SurfaceSide side_of(const Eigen::Vector3d& point, const FeatureName& feature) const;

 private:
  const PlacedCorners& corners_;
  std::vector<std::pair<FeatureName, std::uint32_t>> triangles_;  ///< the triangles at faces and
                                                                  ///< edges, ascending
};

}  // namespace graze::contacts

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/engine/mesh/curves/feature_name.h>
#include <graze/engine/mesh/placed_mesh.h>

namespace graze::contacts {

/// The elements of a placed triangle: itself, or, if it has no area, the one or two edges between
/// its corners, or the point that it is. So an edge that a triangle without area shares with one of
/// its neighbours is an edge of both.
struct Elements {
  std::array<std::array<std::uint32_t, 3>, 2>
      corners;  ///< the corners of each, ascending; an edge repeats one number, a point all
  int count;

  bool has_area() const { return corners[0][0] != corners[0][1] && corners[0][1] != corners[0][2]; }
};

/// The corners of some triangles of a mesh, placed by law 1 and welded: bit-equal positions (-0 and
/// 0 are one) have one number, and the numbers ascend with the positions, lexicographically.
class PlacedCorners {
 public:
  /// Places the corners of these triangles, which ascend.
  PlacedCorners(const PlacedMeshView& placed, std::vector<std::uint32_t> triangles);

  const Eigen::Vector3d& position(std::uint32_t corner) const { return positions_[corner]; }
  const Elements& elements(std::uint32_t triangle) const { return elements_[slot_of(triangle)]; }
  std::span<const std::uint32_t> triangles() const { return triangles_; }
  std::size_t count() const { return positions_.size(); }

  /// Returns the corners' numbers in the order of the mesh's own indices.
  const std::array<std::uint32_t, 3>& corners(std::uint32_t triangle) const {
    return corners_[slot_of(triangle)];
  }

  /// Returns the convex hull of the corners of a feature.
  Triangle hull(const std::array<std::uint32_t, 3>& corner) const;
  Triangle hull(const FeatureName& feature) const;

  /// True if this mesh is first in an order by positions and then by triangles: of two that are not
  /// alike one is.
  bool is_before(const PlacedCorners& other) const;

 private:
  std::size_t slot_of(std::uint32_t triangle) const;
  Elements elements_of(std::array<std::uint32_t, 3> corners) const;

  std::vector<std::uint32_t> triangles_;
  std::vector<std::array<std::uint32_t, 3>> corners_;
  std::vector<Elements> elements_;
  std::vector<Eigen::Vector3d> positions_;
};

}  // namespace graze::contacts

#pragma once

// Finds heights of a mesh above a plane. Private to engine/world.

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <cstdint>
#include <optional>

namespace graze {

/// The height of a set above a plane.
struct Height {
  double height;  ///< the height of the lowest point, metres; negative below the plane
  double slack;   ///< the most by which the height is off, metres
  narrowphase::Vec3 lowest;
};

/// Finds vertices of a placed mesh by their heights above the plane of a half-space. It walks the
/// mesh's tree: heights of a node's box are bounded in the mesh's frame, into which the plane is
/// turned.
class MeshHeights {
 public:
  /// Takes a mesh and a plane; `origin` is that of the plane's frame. All must outlive this. Builds
  /// the mesh's tree if it is not there yet.
  MeshHeights(const PlacedMeshView& mesh, const PlacedHalfSpace& plane,
              const Eigen::Vector3d& origin, Work& work);

  double slack() const { return slack_; }
  /// Returns the height of a vertex by its index. For the plane turned over it is the same number
  /// but for the sign.
  double of_vertex(std::uint32_t index) const;

  /// Returns the height of the lowest vertex, or of the first one met that is not above `enough`.
  Height lowest(double enough) const;
  /// Returns a triangle that, as far as the slack tells, has corners on both sides, or one on the
  /// plane, if there is any.
  std::optional<std::uint32_t> find_crossed() const;

 private:
  struct Range {
    double low, high;
  };
  Range of_node(std::uint32_t node) const;
  narrowphase::Vec3 place(std::uint32_t index) const;

  const PlacedMeshView& mesh_;
  const PlacedHalfSpace& plane_;
  narrowphase::Vec3 origin_;
  Work& work_;
  const bvh::Tree& tree_;
  double own_[3];  ///< the normal in the mesh's frame
  double base_;
  double slack_;
};

}  // namespace graze

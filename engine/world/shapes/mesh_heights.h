#pragma once

// How a mesh lies above a plane. Private to engine/world.

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <cstdint>
#include <optional>

namespace graze {

/// How a set lies above a plane.
struct Height {
  double height;  ///< of the lowest point, metres; negative below
  double slack;   ///< what it is off by, at most
  narrowphase::Vec3 lowest;
};

/// The vertices of a placed mesh above the plane of a half-space, by its tree: a node's box is
/// bounded by the plane turned into the mesh's frame.
class MeshHeights {
 public:
  /// `origin` is that of the plane's frame. All must outlive this. Builds the mesh's tree if it is
  /// not there yet.
  MeshHeights(const PlacedMeshView& mesh, const PlacedHalfSpace& plane,
              const Eigen::Vector3d& origin, Work& work);

  double slack() const { return slack_; }
  /// Of a vertex by its index; the same number as of the plane turned over, but for the sign.
  double of_vertex(std::uint32_t index) const;

  /// Walks towards the lowest vertex, until one is not above `enough`.
  Height lowest(double enough) const;
  /// A triangle that has corners on both sides, or one on the plane, as far as the slack tells.
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

#pragma once

// Finds when a box that goes straight is near nodes of a mesh's tree. Private to engine/world.

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/world/rigid/box_sweep.h>
#include <graze/engine/world/shapes/mesh_descent.h>
#include <Eigen/Core>

#include <cstdint>

namespace graze {

/// The box of a MeshDescent moved along a shift while t goes from 0 to 1, with room around it.
class TreeSweep {
 public:
  /// Takes `shift` and `room` in metres, in the world, and the mesh of the descent. `room` must be
  /// larger than needed by more than 2^-45 of all lengths, which covers the rounding here.
  TreeSweep(const MeshDescent& descent, const PlacedMeshView& mesh, const Eigen::Vector3d& shift,
            double room);

  NearTimes of_node(std::uint32_t node) const {
    const bvh::FloatBox& box = tree_.nodes[node].box;
    return sweep_.of({box.min[0], box.min[1], box.min[2]}, {box.max[0], box.max[1], box.max[2]});
  }
  NearTimes of_triangle(std::uint32_t index) const;

 private:
  const bvh::Tree& tree_;
  const Mesh& mesh_;
  double unit_;
  BoxSweep sweep_;  ///< the box in the tree's frame, with the room
};

}  // namespace graze

#pragma once

// A box that goes straight through a mesh's tree. Private to engine/world.

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/world/shapes/mesh_descent.h>
#include <Eigen/Core>

#include <algorithm>
#include <cstdint>

namespace graze {

/// When something is near a box: from one time to another. Never, if the first is above the last.
struct NearTimes {
  double first, last;
};

/// The box of a MeshDescent moved along a shift while t goes from 0 to 1, with room around it.
class TreeSweep {
 public:
  /// `shift` and `room` in metres, in the world; `mesh` as the descent has it. `room` must have
  /// more than 2^-45 of all lengths beyond what it stands for: what is computed here is off by
  /// less.
  TreeSweep(const MeshDescent& descent, const PlacedMeshView& mesh, const Eigen::Vector3d& shift,
            double room);

  NearTimes of_node(std::uint32_t node) const {
    const bvh::FloatBox& box = tree_.nodes[node].box;
    return of_box({box.min[0], box.min[1], box.min[2]}, {box.max[0], box.max[1], box.max[2]});
  }
  NearTimes of_triangle(std::uint32_t index) const;

 private:
  /// The slabs of a box (Kay, Kajiya, "Ray tracing complex scenes", 1986), which is grown by that
  /// of the set.
  NearTimes of_box(const double (&low)[3], const double (&high)[3]) const {
    NearTimes times{0, 1};
    for (int k = 0; k < 3; ++k) {
      const double from = low[k] - max_[k], to = high[k] - min_[k];
      if (shift_[k] == 0) {
        if (from > 0 || to < 0) return {1, 0};
        continue;
      }
      const double s = from / shift_[k], t = to / shift_[k];
      times.first = std::max(times.first, std::min(s, t));
      times.last = std::min(times.last, std::max(s, t));
    }
    return times;
  }

  const bvh::Tree& tree_;
  const Mesh& mesh_;
  double unit_;
  double min_[3], max_[3];  ///< with the room
  double shift_[3];
};

}  // namespace graze

#pragma once

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

namespace graze::contacts {

/// A placed mesh as a cast sees it: in space, or in the frame of an oriented box (law 3).
struct FramedMesh {
  const PlacedMeshView& placed;
  const Pose* frame = nullptr;  ///< the frame of the box, if there is one

  Eigen::Vector3d point(const Eigen::Vector3d& own) const {
    const Eigen::Vector3d at = narrowphase::place(placed.pose, own);
    return frame != nullptr ? narrowphase::point_into_frame(at, *frame) : at;
  }
  Triangle triangle(std::uint32_t index) const {
    const Triangle own = placed.mesh.triangle(index);
    return {point(own.a), point(own.b), point(own.c)};
  }
};

}  // namespace graze::contacts

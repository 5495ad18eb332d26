#pragma once

// What a shape comes to that slides along a mesh. Private to engine/world.

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/work.h>
#include <graze/engine/world/shape.h>

#include <optional>

namespace graze {

/// A contact after 0.
struct SlidingContact {
  RigidContact contact;
  Eigen::Vector3d normal;  ///< at `low`, unit, from A to B
  Eigen::Vector3d point;   ///< at `low`, between the two, in the common frame
};

/// Of a convex shape and a mesh that does not turn and which it touches at 0, or is no further from
/// than the tolerance: the first contact with a triangle of which that is not so, and which it gets
/// deeper behind than `depth`, metres, and than it is in the mesh at 0 (find_contacts()). So what
/// lies on a floor is told of the wall of the same mesh, and not of the floor. Nothing if there is
/// none, and for all other pairs.
std::optional<SlidingContact> contact_after_sliding(
    const Shape& shape_a, const RigidMotion& motion_a, const Shape& shape_b,
    const RigidMotion& motion_b, const RigidContactSettings& settings, double depth, Work& work);

}  // namespace graze

#pragma once

// Finds what a shape that slides along a mesh comes to. Private to engine/world.

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/work.h>
#include <graze/engine/world/shape.h>

#include <optional>

namespace graze {

/// A contact after time 0.
struct SlidingContact {
  RigidContact contact;
  Eigen::Vector3d normal;  ///< the normal at `low`, unit, from A to B
  Eigen::Vector3d point;   ///< a point between the two at `low`, in the common frame
};

/// Returns the next contact of a convex shape and a mesh that does not turn, where the shape
/// touches the mesh at time 0, or is no further from it than the tolerance. It is the first contact
/// with a triangle that the shape does not touch at 0 in this way, and behind which it gets deeper
/// than `depth`, metres, beyond its depth in the mesh at 0 (find_contacts()). So a shape that lies
/// on a floor meets the wall of the same mesh, and not the floor. It returns nothing if there is no
/// such contact, and for all other pairs.
std::optional<SlidingContact> contact_after_sliding(
    const Shape& shape_a, const RigidMotion& motion_a, const Shape& shape_b,
    const RigidMotion& motion_b, const RigidContactSettings& settings, double depth, Work& work);

}  // namespace graze

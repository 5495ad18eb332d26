#pragma once

// Private to engine/mesh/rigid.

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/work.h>

namespace graze {

/// A box of a tree in the body's frame about the tree's centre, metres.
struct MetricBox {
  double centre[3];
  double half[3];
};

/// A mesh that moves, with what bounds how far it gets. All bounds are upward.
///
/// A point p that turns by an angle d about an axis while time goes on steadily stays, along any
/// direction n, within d^2 / 8 r |n| of the line between its values at both ends, r its distance
/// from the axis: the second derivative there is at most d^2 r |n|. What a shift adds is linear in
/// time and changes nothing. So bodies that a direction keeps apart at both ends of a stretch, by
/// more than what both may bulge, are apart all the time.
struct MovingBody {
  /// Throws PoseError, which begins with `what`. Builds the tree if nobody has.
  MovingBody(const Mesh& of_mesh, const RigidMotion& in_motion, const char* what, Work& work);

  const Mesh& mesh;
  const RigidMotion& motion;
  const bvh::Tree& tree;
  double unit;      ///< metres for each of the tree's
  double turned;    ///< the size of the angle
  double radius;    ///< of all vertices about the axis, metres
  double rounding;  ///< of all that is computed of a placed vertex, metres, along any direction

  /// How far from the axis the points of a box are at most.
  double radius_of(const MetricBox& box) const;

  /// Of a triangle's corners, in the body's frame.
  double radius_of(const Triangle& triangle) const;
};

}  // namespace graze

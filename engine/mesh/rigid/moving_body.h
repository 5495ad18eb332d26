#pragma once

// This is private to engine/mesh/rigid.

#include <graze/bvh/skins/float_volumes.h>
#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/rigid/body_parts.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/work.h>

#include <span>

namespace graze {

/// A mesh that moves, with bounds of how far it gets. All bounds are upward.
struct MovingBody {
  /// Builds the tree and its boxes if nobody has. Throws PoseError, which begins with `what`.
  MovingBody(const Mesh& of_mesh, const RigidMotion& in_motion, const char* what, Work& work);

  const Mesh& mesh;
  const RigidMotion& motion;
  const bvh::Tree& tree;
  std::span<const bvh::FloatObb> boxes;  ///< one box for each node
  double unit;                           ///< metres for each unit of the tree's
  double turned;                         ///< the size of the angle
  double radius;                         ///< no vertex is further than this from the axis, metres
  double rounding;  ///< the rounding of all that is computed of a placed vertex, metres, along any
                    ///< direction

  /// Returns the box of a node, and how far from the axis its points are at most.
  BodyBox box(std::uint32_t node) const;

  BodyTriangle triangle(std::uint32_t index) const;

 private:
  double distance_from_axis(const double* point) const;
  double with_rounding(double radius) const;
};

}  // namespace graze

#pragma once

// These are balls around meshes, by which a query sees what is far away before it asks a tree. They
// are private to engine/mesh.

#include <graze/bvh/aabb.h>
#include <graze/bvh/pose.h>

#include <span>

namespace graze {

struct MeshBall {
  double centre[3];  ///< the middle of the mesh's bounds
  double radius;     ///< no vertex is further than this from there; infinite where that could
                     ///< overflow
  double sizes;      ///< sum of the magnitudes of the bounds' coordinates
};

/// Returns a ball around vertices that lie within `bounds`, in linear time.
MeshBall ball_around(std::span<const Eigen::Vector3d> vertices, const Aabb& bounds);

struct PlacedBall {
  const Pose& pose;
  const MeshBall& ball;
};

/// True if check_placement() lets both poses in and no two placed points of the meshes are equal,
/// both for sure: so it is for most pairs of far meshes, and this sees it in a fraction of the time
/// that frames of trees take. False tells nothing.
bool are_surely_far_apart(const PlacedBall& a, const PlacedBall& b);

}  // namespace graze

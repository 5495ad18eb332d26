#pragma once

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>

namespace graze {

/// A translation of B after which two meshes are apart.
struct SeparatingTranslation {
  double distance;              ///< along `direction`, metres, >= 0
  Eigen::Vector3d direction;    ///< a unit vector, to a few ulp
  Eigen::Vector3d translation;  ///< the product distance * direction, metres, each coordinate
                                ///< rounded
  Pose pose_b;                  ///< the pose of B with `translation` added to its own, rounded

  bool operator==(const SeparatingTranslation& other) const {
    return distance == other.distance && direction == other.direction &&
           translation == other.translation && are_equal(pose_b, other.pose_b);
  }
};

/// Returns the translation of B to the last contact along a direction of any length, which is
/// normalised: intersects() is false for `pose_b`, and for B moved further along the direction as
/// far as its placement does not overflow. It asks for no more than that: at smaller distances the
/// surfaces may or may not meet. The distance is 0 if they never do. It is the smallest for
/// surfaces that are thicker by the rounding of law 1, a few 2^-50 of the largest placed
/// coordinates of A and B together: more than the last contact by that over the cosine between the
/// direction and the normal of the contact, or, where surfaces pass that close alongside each
/// other, the distance at which they have passed.
///
/// Only surfaces count: a mesh inside another is led out of it. Throws InputError for a direction
/// that is zero or not finite, PoseError as intersects() does, also for a pose of B that would
/// overflow.
SeparatingTranslation separating_translation(const PlacedMeshView& mesh_a,
                                             const PlacedMeshView& mesh_b,
                                             const Eigen::Vector3d& direction,
                                             Work* work = nullptr);

/// Returns the shortest of these translations along the normals of the deepest contacts, the axes
/// and the line between the middles of the meshes, each both ways. It separates the meshes, and so
/// is no shorter than the shortest one that does; by how much longer is not known. It is zero if
/// the surfaces do not meet. Throws likewise.
SeparatingTranslation separating_translation(const PlacedMeshView& mesh_a,
                                             const PlacedMeshView& mesh_b, Work* work = nullptr);

}  // namespace graze

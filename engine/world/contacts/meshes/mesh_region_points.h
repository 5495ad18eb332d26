#pragma once

// The contact candidates of a region of two meshes. Private to engine/world.

#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/contacts/contact_regions.h>
#include <graze/engine/world/contacts/meshes/inner_surface.h>

#include <span>

namespace graze {

/// One way out of a piece.
struct MeshRegion {
  const TouchedTriangle& left;  ///< the triangle whose feature is left last
  bool is_of_a;                 ///< whether that is A's; the way out is A's all the same
  std::span<const MeshCrossing> crossings;  ///< of the piece, or those of the triangle
  const InnerPart* inner_a;
  const InnerPart* inner_b;
  bool is_scattered;  ///< of the points that are farthest two need be no edge
  const Pose& pose_a;
  const Pose& pose_b;
};

/// Where a face is left, points of the other mesh with their depths behind it, and where faces lie
/// along each other points of both; where an edge is left, the same behind the faces that are
/// nearly at right angles to the way out, or the point in which two edges meet. Of all these four
/// at most: the ends in four directions that turn with A, so that they are the same ones in the
/// next step. One is as deep as the region, to three thousandths: the deepest point stands for an
/// end where none is.
void add_region_points(const MeshRegion& region, ContactCandidates& candidates);

}  // namespace graze

#pragma once

// Finds the contact candidates of a region of two meshes. Private to engine/world.

#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/contacts/contact_regions.h>
#include <graze/engine/world/contacts/meshes/inner_surface.h>

#include <span>

namespace graze {

/// One way out of a piece.
struct MeshRegion {
  const TouchedTriangle& left;  ///< the triangle whose feature is left last
  bool is_of_a;                 ///< whether that triangle is A's; the way out is always A's
  std::span<const MeshCrossing> crossings;  ///< the crossings of the piece, or those of the
                                            ///< triangle
  const InnerPart* inner_a;
  const InnerPart* inner_b;
  bool is_scattered;  ///< whether two of the farthest points need not be an edge
  const Pose& pose_a;
  const Pose& pose_b;
};

/// Adds the contacts of a region. Where a face is left, these are points of the other mesh with
/// their depths behind it, and points of both where faces lie along each other. Where an edge is
/// left, they are points behind the faces that are nearly at right angles to the way out, or the
/// point in which two edges meet. At most four of all these are added: the ends in four directions
/// that turn with A, so that they are the same in the next step. One of them is as deep as the
/// region, to three thousandths: the deepest point takes the place of an end if no end is.
void add_region_points(const MeshRegion& region, ContactCandidates& candidates);

}  // namespace graze

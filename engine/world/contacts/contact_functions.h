#pragma once

// The pair functions for contacts: what each row of the table of pairs offers as contact
// candidates. A's kind is not above B's, and points are relative to the origin that is handed back.
// Private to engine/world.

#include <graze/engine/world/shapes/pair_input.h>
#include <graze/narrowphase/convex/contact/contact_points.h>

#include <vector>

namespace graze {

/// The contact candidates of one pair, of which reduce() leaves four. The vectors are kept from one
/// pair to the next, so that no step of a simulation allocates.
struct ContactCandidates {
  Eigen::Vector3d origin;
  std::vector<narrowphase::ContactPoint> list;
  std::vector<narrowphase::ContactPoint>
      from_behind;  ///< of triangles of a mesh that face away from the shape
  std::vector<narrowphase::ContactPoint>
      found;                  ///< of one triangle, before it is known which list they belong to
  std::vector<bool> is_seen;  ///< for each vertex of a mesh, whether it was looked at

  void clear() {
    list.clear();
    from_behind.clear();
  }
};

void candidates_of_cores(const PlacedShapeView& a, const PlacedShapeView& b,
                         ContactCandidates& candidates, Work& work);
/// Two boxes, which need not touch: no contacts then.
void candidates_of_boxes(const PlacedShapeView& a, const PlacedShapeView& b,
                         ContactCandidates& candidates, Work& work);
void candidates_with_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                           ContactCandidates& candidates);
void candidates_of_mesh_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                              ContactCandidates& candidates, Work& work);
void candidates_of_mesh_core(const PlacedShapeView& a, const PlacedShapeView& b,
                             ContactCandidates& candidates, Work& work);
/// A sphere or a box and a mesh, which need not touch: no contacts then.
void candidates_of_mesh_volume(const PlacedShapeView& a, const PlacedShapeView& b,
                               ContactCandidates& candidates, Work& work);
/// Two meshes, likewise.
void candidates_of_meshes(const PlacedShapeView& a, const PlacedShapeView& b,
                          ContactCandidates& candidates, Work& work);
/// Likewise, where triangles go through each other. False if that does not tell.
bool candidates_of_crossings(const PlacedShapeView& a, const PlacedShapeView& b,
                             ContactCandidates& candidates, Work& work);

}  // namespace graze

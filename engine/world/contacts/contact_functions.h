#pragma once

// The pair functions for contacts: what each row of the table of pairs offers as contact
// candidates. A's kind is not above B's, and points are relative to the origin that is handed back.
// Private to engine/world.

#include <graze/engine/world/shapes/pair_input.h>
#include <graze/narrowphase/convex/contact/contact_points.h>
#include <graze/narrowphase/convex/contact/reduction.h>

#include <vector>

namespace graze {

/// The contact candidates of one pair: of those of each region reduce() leaves four. The vectors
/// are kept from one pair to the next, so that no step of a simulation allocates.
struct ContactCandidates {
  Eigen::Vector3d origin;
  /// Metres. Where it is not 0, candidates are those of A grown by it: their depths, which count
  /// from its surface, are >= 0, and write_manifold() takes the margin off again.
  double margin = 0;
  std::vector<narrowphase::ContactPoint> list;
  std::vector<std::size_t> ends;                 ///< where in the list each region's candidates end
  std::vector<narrowphase::ContactPoint> found;  ///< of one region, before it is in the list
  std::vector<bool> is_seen;  ///< for each vertex of a mesh, whether it was looked at

  void clear() {
    list.clear();
    ends.clear();
  }
  /// What the list holds beyond the regions so far is one more.
  void end_region() {
    if (list.size() > (ends.empty() ? 0 : ends.back())) ends.push_back(list.size());
  }
};

/// Whatever their order: those of the pair that is_swapped() puts in order.
void candidates_of_pair(const PlacedShapeView& a, const PlacedShapeView& b,
                        ContactCandidates& candidates, Work& work);
/// Of the candidates of each region four are left. They are mirrored where the pair was swapped.
void write_manifold(ContactCandidates& candidates, bool is_mirrored, Manifold& manifold);
/// This thread's, without any.
ContactCandidates& empty_candidates(double margin);

/// Makes the depth that part() calls 0 of cores that are apart negative: how far apart they are
/// along the normal.
void sign_depth(const narrowphase::Core& core_a, const narrowphase::Core& core_b,
                narrowphase::Parting& parting);

/// Leaves four of the candidates from `first` on, if there are more: those that stand for a region.
void reduce_from(std::size_t first, const narrowphase::ContactSurfaces& surfaces,
                 ContactCandidates& candidates);

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
/// Two meshes, likewise, and whatever the margin.
void candidates_of_meshes(const PlacedShapeView& a, const PlacedShapeView& b,
                          ContactCandidates& candidates, Work& work);
/// The same where triangles go through each other. False if that does not tell.
bool candidates_of_crossings(const PlacedShapeView& a, const PlacedShapeView& b,
                             ContactCandidates& candidates, Work& work);
/// The same of meshes that are so large or so small that products of five lengths may overflow or
/// underflow: those of the same meshes scaled by a power of two, scaled back. Scaling changes no
/// bit of a placed coordinate (law 1) but of one that is denormal. Returns false, and does nothing,
/// for all others.
bool candidates_of_scaled_meshes(const PlacedShapeView& a, const PlacedShapeView& b,
                                 ContactCandidates& candidates, Work& work);
/// Adds to the candidates of two meshes, ungrown so far, what the margin demands.
void add_near_triangles(const PlacedShapeView& a, const PlacedShapeView& b,
                        ContactCandidates& candidates, Work& work);

}  // namespace graze

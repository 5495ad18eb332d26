#pragma once

// The pair functions for contacts: each row of the table of pairs has a function that offers
// contact candidates. A's kind is not above B's, and points are relative to the origin in the
// candidates. Private to engine/world.

#include <graze/engine/world/shapes/pair_input.h>
#include <graze/narrowphase/convex/contact/contact_points.h>
#include <graze/narrowphase/convex/contact/reduction.h>

#include <vector>

namespace graze {

/// The contact candidates of one pair, of which reduce() leaves four of each region. The vectors
/// are kept from one pair to the next, so that no step of a simulation allocates.
struct ContactCandidates {
  Eigen::Vector3d origin;
  /// The margin, metres. If it is not 0, candidates are those of A grown by it: their depths, which
  /// count from the grown surface, are >= 0, and write_manifold() subtracts the margin again.
  double margin = 0;
  std::vector<narrowphase::ContactPoint> list;
  std::vector<std::size_t> ends;                 ///< the end of each region's candidates in the
                                                 ///< list
  std::vector<narrowphase::ContactPoint> found;  ///< candidates of one region, before they are in
                                                 ///< the list
  std::vector<bool> is_seen;  ///< for each vertex of a mesh, whether it was looked at

  void clear() {
    list.clear();
    ends.clear();
  }
  /// Makes a region of the candidates in the list after the last region, if there are any.
  void end_region() {
    if (list.size() > (ends.empty() ? 0 : ends.back())) ends.push_back(list.size());
  }
};

/// Finds the candidates of a pair in any order of kinds: those of the pair that is_swapped() puts
/// in order.
void candidates_of_pair(const PlacedShapeView& a, const PlacedShapeView& b,
                        ContactCandidates& candidates, Work& work);
/// Writes the contacts: up to four of the candidates of each region, mirrored if the pair was
/// swapped.
void write_manifold(ContactCandidates& candidates, bool is_mirrored, Manifold& manifold);
/// Returns this thread's candidates, emptied.
ContactCandidates& empty_candidates(double margin);

/// Makes the depth of cores that are apart, which is 0 by part(), negative: minus how far apart
/// they are along the normal.
void sign_depth(const narrowphase::Core& core_a, const narrowphase::Core& core_b,
                narrowphase::Parting& parting);

/// Leaves four of the candidates from `first` on, if there are more. These stand for the region.
void reduce_from(std::size_t first, const narrowphase::ContactSurfaces& surfaces,
                 ContactCandidates& candidates);

void candidates_of_cores(const PlacedShapeView& a, const PlacedShapeView& b,
                         ContactCandidates& candidates, Work& work);
/// Finds the candidates of two boxes: none if the boxes do not touch.
void candidates_of_boxes(const PlacedShapeView& a, const PlacedShapeView& b,
                         ContactCandidates& candidates, Work& work);
void candidates_with_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                           ContactCandidates& candidates);
void candidates_of_mesh_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                              ContactCandidates& candidates, Work& work);
void candidates_of_mesh_core(const PlacedShapeView& a, const PlacedShapeView& b,
                             ContactCandidates& candidates, Work& work);
/// Finds the candidates of a sphere or a box and a mesh: none if they do not touch.
void candidates_of_mesh_volume(const PlacedShapeView& a, const PlacedShapeView& b,
                               ContactCandidates& candidates, Work& work);
/// Finds the candidates of two meshes: none if they do not touch, whatever the margin is.
void candidates_of_meshes(const PlacedShapeView& a, const PlacedShapeView& b,
                          ContactCandidates& candidates, Work& work);
/// Finds the candidates of two meshes whose triangles go through each other. Returns false if that
/// does not tell the contacts.
bool candidates_of_crossings(const PlacedShapeView& a, const PlacedShapeView& b,
                             ContactCandidates& candidates, Work& work);
/// Finds the candidates of meshes that are so large or so small that products of five lengths may
/// overflow or underflow: it scales the meshes by a power of two, and scales their candidates back.
/// Scaling changes no bit of a placed coordinate (law 1) unless it is denormal. Returns false, and
/// does nothing, for all other meshes.
bool candidates_of_scaled_meshes(const PlacedShapeView& a, const PlacedShapeView& b,
                                 ContactCandidates& candidates, Work& work);
/// Adds the candidates that the margin demands to those of two meshes without margin.
void add_near_triangles(const PlacedShapeView& a, const PlacedShapeView& b,
                        ContactCandidates& candidates, Work& work);

}  // namespace graze

#pragma once

// Finds the contact candidates of a convex shape and a mesh. Private to engine/world.

#include <graze/engine/mesh/data/mesh_patch.h>
#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/contacts/contact_regions.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace graze {

/// Returns an edge in the form that the solvers take.
narrowphase::Core edge_core(const narrowphase::Vec3& from, const narrowphase::Vec3& to);

/// The candidates from the triangles of a mesh that the shape touches. First each triangle is
/// added, then finish() finds the regions and their contacts. Slivers count only where nothing else
/// is touched; each is parted from the shape along the shortest way.
class TriangleCandidates {
 public:
  /// Begins without triangles. The core must be grown by the candidates' margin.
  TriangleCandidates(const narrowphase::Core& core, const PlacedMeshView& mesh,
                     ContactCandidates& candidates, Work& work);

  /// Adds a triangle that the shape may touch.
  void add(std::uint32_t index, const narrowphase::Core& triangle);
  /// Adds a triangle that the shape touches.
  void offer(std::uint32_t index, const narrowphase::Core& triangle);
  /// Adds a triangle that it touches, and that is no sliver, with the exit by which it is left.
  void offer(const LocalParting& parting, const narrowphase::Core& triangle);

  bool has_touched() const { return !s_.touched.empty() || !s_.slivers.empty(); }

  void finish();

 private:
  /// Points are on a surface to this share of the shape's size.
  static constexpr double kOnSurface = 0x1p-36;

  /// Memory that is kept from one pair to the next, so that no step of a simulation allocates.
  struct Scratch {
    std::vector<TouchedTriangle> touched, slivers, all;
    std::vector<std::uint32_t> held;  ///< the vertices of the faces of a region, ascending
    ContactRegions regions;
  };
  static Scratch& scratch();

  /// The triangles of a region, and the one that says its way out.
  struct RegionMembers {
    const TouchedTriangle& speaker;
    std::span<const TouchedTriangle> members;
    std::size_t first;  ///< the region's first contact in the list of candidates
  };

  /// Returns the shape without the margin.
  const narrowphase::Core& bare() const { return bare_ ? *bare_ : core_; }
  narrowphase::Parting bare(narrowphase::Parting parting) const;
  bool is_behind(const narrowphase::Core& triangle) const;
  bool lies_on(const narrowphase::Vec3& normal);
  std::uint64_t face_feature(std::uint32_t triangle) const;
  void part_from_slivers();
  void add_region(std::span<TouchedTriangle> members);
  void add_over_face(const TouchedTriangle& face, const narrowphase::Parting& parting);
  void add_near_faces(const TouchedTriangle& member);
  void add_member(const TouchedTriangle& member);
  bool add_deepest(const TouchedTriangle& member, std::uint64_t of_shape);
  void add_nearest(const TouchedTriangle& member);
  bool add_before(const narrowphase::Vec3& on_mesh, const narrowphase::Vec3& normal);
  void add_apart(const narrowphase::Vec3& on_shape, const narrowphase::Vec3& on_mesh,
                 const narrowphase::Vec3& normal);
  void add_parting(const RegionMembers& region, double deepest, std::uint64_t of_shape);
  bool add_last_touch(const RegionMembers& region, double deepest, std::uint64_t of_shape);
  void add_grazing(const TouchedTriangle& member);
  void add_alone(const TouchedTriangle& member);
  void take(std::uint64_t of_mesh);
  void drop_doubles(std::size_t first);
  bool is_held(std::uint32_t vertex) const;
  bool is_on_shape(const narrowphase::Vec3& point) const;

  const narrowphase::Core& core_;
  std::optional<narrowphase::Core> bare_;  ///< the shape without the margin, if there is one
  ContactCandidates& candidates_;
  FacingFeatures features_;
  MeshNumbers numbers_;
  LocalPartings partings_;
  LocalPartings lying_;  ///< the partings of a shape that lies on a triangle with a face
  Work& work_;
  narrowphase::Vec3 asked_normal_;  ///< the normal that lies_on() was asked about last
  bool is_lying_ = false;
  Scratch& s_;
};

}  // namespace graze

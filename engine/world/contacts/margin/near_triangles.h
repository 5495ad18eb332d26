#pragma once

// Finds what is near of two meshes, though it may not touch. Private to engine/world.

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>
#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/contacts/region_ends.h>
#include <graze/narrowphase/convex/core/core.h>

#include <cstdint>
#include <vector>

namespace graze {

/// Adds to the candidates of two meshes those that a margin demands: for each direction in which
/// features face each other that are apart by no more than the margin, the nearest points and what
/// lies between faces nearly at right angles to it. The regions in which the meshes cross take in
/// what is near beside them in the same way. Directions that differ by less than two degrees are
/// one, so that it does not matter whose face is nearer, which depends on rounding where faces lie
/// along each other. Four points of each region are left, with the features of meshes that touch,
/// so that a body that rocks keeps its contacts. It costs O(t log n) for t triangles of A near B,
/// and the pairs among them.
class NearTriangles {
 public:
  NearTriangles(const PlacedMeshView& a, const PlacedMeshView& b, ContactCandidates& candidates,
                Work& work);
  void add();

 private:
  struct NearPair {
    std::uint32_t index_a;
    std::uint32_t index_b;
    narrowphase::Core of_a, of_b;
    narrowphase::Vec3 normal_a, normal_b;
    narrowphase::Vec3 point_a, point_b;  ///< the points nearest to each other
    double distance;
  };
  struct RegionExit {
    narrowphase::Vec3 normal;
    double depth;         ///< the greatest depth of a point of A grown by the margin
    bool is_first_along;  ///< true if no region before it is left along the same direction
  };
  struct LocalExit {
    narrowphase::Vec3 normal;
    const NearPair* pair;
  };
  struct Touch {
    std::uint32_t region;
    MetPoints met;  ///< the points of A grown by the margin and of B
  };
  /// Memory that is kept from one pair to the next, so that no step of a simulation allocates.
  struct Scratch {
    std::vector<NearPair> pairs;
    std::vector<RegionExit> exits;
    std::vector<LocalExit> local;
    std::vector<Touch> touches;
    std::vector<MetPoints> met;  ///< the points of one region
  };
  static Scratch& scratch();

  void grow_known();
  void find_near_pairs();
  void find_exits();
  static narrowphase::Vec3 exit_direction(const NearPair& pair);
  bool is_local(const NearPair& pair, const narrowphase::Vec3& normal, double negligible) const;
  std::size_t along(const narrowphase::Vec3& normal) const;
  std::uint32_t add_exit(const narrowphase::Vec3& normal, double depth);
  std::uint32_t region_of(const narrowphase::Vec3& normal);
  void add_faces(const NearPair& pair);
  double gather(std::uint32_t region);
  void rebuild();

  const PlacedMeshView mesh_a_;
  const PlacedMeshView mesh_b_;
  ContactCandidates& candidates_;
  Work& work_;
  Scratch& s_;
};

}  // namespace graze

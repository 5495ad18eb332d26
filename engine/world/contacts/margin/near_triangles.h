#pragma once

// What is near of two meshes, though it may not touch. Private to engine/world.

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
/// what lies beside them, likewise. Directions that differ by less than two degrees are one, so
/// that whose face is nearer, which is rounding where faces lie along each other, is no matter. Of
/// each region four points are left, named as those of meshes that touch are: a body that rocks
/// keeps its contacts. O(t log n) for t triangles of A near B, and the pairs among them.
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
    narrowphase::Vec3 point_a, point_b;  ///< nearest to each other
    double distance;
  };
  struct RegionExit {
    narrowphase::Vec3 normal;
    double depth;         ///< of A grown: the greatest of a point
    bool is_first_along;  ///< no region before it is left along the same direction
  };
  struct LocalExit {
    narrowphase::Vec3 normal;
    const NearPair* pair;
  };
  struct Touch {
    std::uint32_t region;
    MetPoints met;  ///< of A grown
  };
  /// Kept from one pair to the next, so that no step of a simulation allocates.
  struct Scratch {
    std::vector<NearPair> pairs;
    std::vector<RegionExit> exits;
    std::vector<LocalExit> local;
    std::vector<Touch> touches;
    std::vector<MetPoints> met;  ///< of one region
  };
  static Scratch& scratch();

  void grow_known();
  void find_pairs();
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

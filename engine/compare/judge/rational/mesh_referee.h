#pragma once

#include <graze/engine/compare/judge/rational/box_tree.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/narrowphase/touch.h>

#include <gmpxx.h>
#include <optional>
#include <vector>

namespace graze::compare {

/// The arbiter for two placed meshes, surfaces only: law 1 places them, all else is integers and
/// rationals. Slow, and right.
class MeshReferee {
 public:
  /// With Touch::Exclude a hit is a pair that crosses.
  MeshReferee(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
              Touch touch = Touch::Include);

  /// A pair that shares a point, if there is one.
  std::optional<TrianglePair> find_hit() const;

  /// All of them, ascending.
  std::vector<TrianglePair> find_hits() const;

  struct Gap {
    mpq_class square;  ///< of the distance, m^2
    TrianglePair pair;
  };
  /// The least distance, 0 if a pair is a hit. A pair that is near, if one is known, saves time.
  Gap find_gap(const std::optional<TrianglePair>& hint = std::nullopt) const;

  bool is_hit(const TrianglePair& pair) const;
  const std::vector<Triangle>& triangles_a() const { return triangles_a_; }
  const std::vector<Triangle>& triangles_b() const { return triangles_b_; }
  const Triangle& triangle_a(std::uint32_t index) const { return triangles_a_[index]; }
  const Triangle& triangle_b(std::uint32_t index) const { return triangles_b_[index]; }

 private:
  Touch touch_;
  std::vector<Triangle> triangles_a_;
  std::vector<Triangle> triangles_b_;
  BoxTree tree_a_;
  BoxTree tree_b_;
};

/// How far a point is from the nearest of some triangles: exact, and rounded once.
double distance_to(const std::vector<Triangle>& surface, const Eigen::Vector3d& point);

/// The largest absolute coordinate of all placed triangles.
double largest_coordinate(const MeshReferee& referee);

/// How far B must be moved along a unit vector until a plane across it parts the two; negative if
/// one does already. In double, off by some ulp of the largest coordinate.
double overlap_along(const MeshReferee& referee, const Eigen::Vector3d& normal);

}  // namespace graze::compare

#pragma once

#include <graze/engine/compare/judge/rational/box_tree.h>
#include <graze/engine/compare/judge/rational/referee_mesh.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/narrowphase/touch.h>

#include <gmpxx.h>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace graze::compare {

/// This is the arbiter for two placed meshes, surfaces only: law 1 places them, and all else is in
/// integers and rationals, but for what rounded numbers with bounds of their errors prove
/// (surely_intersects()). Many threads may ask it.
class MeshReferee {
 public:
  /// With Touch::Exclude a hit is a pair that crosses.
  MeshReferee(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
              Touch touch = Touch::Include);

  /// Returns a pair that shares a point, if there is one.
  std::optional<TrianglePair> find_hit() const;

  /// Returns all such pairs, ascending.
  std::vector<TrianglePair> find_hits() const;

  struct Gap {
    mpq_class square;  ///< the square of the distance, m^2
    TrianglePair pair;
  };
  /// Finds the least distance, 0 if a pair is a hit. A pair that is near, if one is known, saves
  /// time.
  Gap find_gap(const std::optional<TrianglePair>& hint = std::nullopt) const;

  bool is_hit(const TrianglePair& pair) const;
  const std::vector<Triangle>& triangles_a() const { return a_.triangles(); }
  const std::vector<Triangle>& triangles_b() const { return b_.triangles(); }
  Triangle triangle_a(std::uint32_t index) const { return a_.triangle(index); }
  Triangle triangle_b(std::uint32_t index) const { return b_.triangle(index); }

 private:
  /// Holds a mesh where it is. Few questions need all of its triangles there.
  class Surface {
   public:
    explicit Surface(const PlacedMeshView& mesh);
    Triangle triangle(std::uint32_t index) const;
    const std::vector<Triangle>& triangles() const;
    const BoxTree& tree() const { return known_->tree(); }  ///< the tree in the mesh's own frame
    const Pose& pose() const { return pose_; }

   private:
    std::shared_ptr<const RefereeMesh> known_;
    Pose pose_;
    mutable std::once_flag once_;
    mutable std::vector<Triangle> triangles_;
  };

  bool is_hit(const Triangle& a, const Triangle& b) const;
  template <typename OnHit>
  void for_each_hit(const OnHit& on_hit) const;

  Touch touch_;
  Surface a_;
  Surface b_;
};

/// Returns how far a point is from the nearest of some triangles: exactly, and rounded once.
double distance_to(const std::vector<Triangle>& surface, const Eigen::Vector3d& point);

/// Returns the largest absolute coordinate of all placed triangles.
double largest_coordinate(const MeshReferee& referee);

/// Returns how far B must be moved along a unit vector until a plane across it parts the two;
/// negative if one does already. It computes in double, off by some ulp of the largest coordinate.
double overlap_along(const MeshReferee& referee, const Eigen::Vector3d& normal);

}  // namespace graze::compare

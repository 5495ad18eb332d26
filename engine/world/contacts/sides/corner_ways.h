#pragma once

// Finds the ways on which a body that is known by points alone, as a mesh is, leaves a corner.
// Private to engine/world.

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/world/contacts/facing_features.h>
#include <graze/engine/world/contacts/local_parting.h>
#include <graze/engine/world/contacts/mesh_placing.h>
#include <graze/narrowphase/convex/core/core.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace graze {

/// The ways past corners of a mesh along which a body leaves with a face of its convex hull, which
/// is not known: it takes too long to build, and most of its faces look elsewhere. Some points of
/// the body bound the depth along each direction from below. Where the bound is least among the
/// directions that a corner faces, and below the limit, it is replaced by what the body has.
///
/// Looks at corners whose triangles go round them once, each edge between two of them, and which
/// face the sum of these triangles' normals.
class CornerWays {
 public:
  struct Way {
    std::uint32_t vertex;  ///< among welded vertices
    narrowphase::Exit exit;
  };

  /// Lengths up to the allowance count as 0. The core, the mesh and the features must outlive it.
  CornerWays(const narrowphase::Core& core, const PlacedMeshView& mesh,
             const narrowphase::Vec3& origin, const FacingFeatures& features, double allowance);

  /// Takes a triangle, no sliver, whose corners count, and the body's support point against its
  /// normal.
  void see(std::uint32_t triangle, const narrowphase::Vec3& deepest);

  /// Returns the shortest way past a corner that counts, if it is below the limit. Others that are
  /// as long are found, too.
  std::optional<LocalParting> shortest(double limit);
  std::span<const Way> found() const { return s_.found; }

 private:
  struct SeenTriangle {
    std::uint32_t triangle;
    narrowphase::Vec3 deepest;
  };
  struct Corner {
    std::uint32_t triangle;  ///< one of those around it
    int k;
    std::uint32_t vertex;
    narrowphase::Vec3 at;
  };
  /// Memory that is kept from one pair to the next, so that no step of a simulation allocates.
  struct Scratch {
    std::vector<SeenTriangle> seen;
    std::vector<std::uint32_t> asked;        ///< for each vertex the last call that asked about it
    std::uint32_t call = 0;                  ///< the number of this call
    std::vector<narrowphase::Vec3> points;   ///< of the body
    std::vector<narrowphase::Vec3> normals;  ///< of the triangles around a corner
    std::vector<narrowphase::Vec3> offsets;  ///< from points that bound the depth to the corner
    std::vector<Way> found;
  };
  static Scratch& scratch();

  void begin();
  bool is_too_far(const Corner& corner, const narrowphase::Vec3& deepest, double limit) const;
  bool go_round(const Corner& corner) const;
  double search(const Corner& corner, double limit);
  double search_within(const Corner& corner, std::size_t first, double limit);
  void settle_arc(const Corner& corner, std::size_t first, double limit);
  std::optional<narrowphase::Exit> exit_at(const Corner& corner, const std::size_t (&of)[3],
                                           double limit);
  double bound(const narrowphase::Vec3& direction) const;
  std::optional<double> settled_depth(const Corner& corner, const narrowphase::Vec3& direction);
  bool is_full() const;
  LocalParting parting_of(const Way& way) const;

  const narrowphase::Core& core_;
  MeshPlacing placing_;
  const FacingFeatures& features_;
  double allowance_;
  Scratch& s_;
};

}  // namespace graze

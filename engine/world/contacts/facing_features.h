#pragma once

// Which directions the edges and corners of a placed mesh face. Private to engine/world.

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/world/contacts/mesh_placing.h>
#include <graze/narrowphase/convex/core/core.h>
#include <graze/narrowphase/convex/depth/facing_depth.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace graze {

struct VertexFans;

/// A feature of a mesh faces a direction if what of the mesh is around it is not ahead of it: a
/// triangle its normal, a convex edge the arc between the normals of both of its triangles, a
/// corner a cone. Edges that are flat or hollow face no more than their triangles do. An edge of
/// one triangle alone, the end of a surface, faces what is between that triangle's normal and
/// straight ahead. The pairs of directions that features of two bodies face towards each other are
/// those in which the bodies part locally.
class FacingFeatures {
 public:
  /// Points are relative to the origin. The mesh must outlive it. Computes the mesh's fans of
  /// triangles if they are not there yet.
  FacingFeatures(const PlacedMeshView& mesh, const narrowphase::Vec3& origin);

  /// A triangle so flat that its normal means nothing: its neighbours stand for it.
  static bool is_sliver(const narrowphase::Core& triangle);

  /// The arc of the edge from corner k to the next of a triangle that is no sliver, whose unit
  /// normal is `normal`; nothing if that is all that the edge faces.
  std::optional<narrowphase::DirectionArc> arc(std::uint32_t index, int k,
                                               const narrowphase::Core& triangle,
                                               const narrowphase::Vec3& normal) const;

  /// Whether a corner of a triangle faces a unit direction. Remembers a few answers: not for more
  /// than one thread.
  bool corner_faces(std::uint32_t index, int k, const narrowphase::Vec3& direction) const;

  /// The triangle that a point in the plane of another lies in, if the surface goes on flat from
  /// there.
  std::optional<std::uint32_t> flat_triangle(std::uint32_t index, const narrowphase::Core& triangle,
                                             const narrowphase::Vec3& point) const;

  /// A triangle as the solvers take it.
  narrowphase::Core placed_triangle(std::uint32_t index) const;

  /// The triangles around a welded vertex.
  std::span<const std::uint32_t> fan(std::uint32_t vertex) const;

  /// A corner's number among welded vertices.
  std::uint32_t vertex(std::uint32_t index, int k) const;

 private:
  /// Narrows the directions that an edge faces by the triangles beside it.
  class Narrowing;

  narrowphase::Vec3 placed(std::uint32_t vertex) const;
  bool vertex_faces(std::uint32_t of, const narrowphase::Vec3& direction) const;
  std::optional<std::uint32_t> neighbour(std::uint32_t s, std::uint32_t t,
                                         std::uint32_t without) const;
  /// An end of an edge: a vertex and where it is.
  struct End {
    std::uint32_t vertex;
    narrowphase::Vec3 point;
  };
  void narrow(Narrowing& narrowing, const End& low, const End& high, std::uint32_t without,
              int depth) const;

  const PlacedMeshView& mesh_;
  MeshPlacing placing_;
  std::span<const std::uint32_t> welded_;
  std::span<const TriangleIndices> triangles_;
  const VertexFans& fans_;

  /// Thousands of triangles may share a corner, and ask the same of it.
  struct AskedCorner {
    std::uint32_t vertex = 0xffffffffu;
    narrowphase::Vec3 direction;
    bool is_faced = false;
  };
  mutable std::array<AskedCorner, 8> asked_;
};

}  // namespace graze

#pragma once

// Finds which directions the edges and corners of a placed mesh face. Private to engine/world.

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

/// The directions that the features of a mesh face. A feature faces a direction if nothing of the
/// mesh around it is ahead of it: a triangle faces its normal, a convex edge the arc between the
/// normals of both of its triangles, a corner a cone. Edges that are flat or hollow face no more
/// than their triangles do. An edge of only one triangle, the end of a surface, faces all
/// directions between that triangle's normal and straight ahead. Two bodies part locally in the
/// directions that features of both face towards each other.
class FacingFeatures {
 public:
  /// Points are relative to the origin. The mesh must outlive it. Computes the mesh's fans of
  /// triangles if they are not there yet.
  FacingFeatures(const PlacedMeshView& mesh, const narrowphase::Vec3& origin);

  /// True for a triangle so flat that its normal means nothing; its neighbours are used in its
  /// place.
  static bool is_sliver(const narrowphase::Core& triangle);

  /// Returns the arc of the edge from corner k to the next of a triangle that is no sliver and
  /// whose unit normal is `normal`, or nothing if the edge faces only that normal.
  std::optional<narrowphase::DirectionArc> arc(std::uint32_t index, int k,
                                               const narrowphase::Core& triangle,
                                               const narrowphase::Vec3& normal) const;

  /// True if a corner of a triangle faces a unit direction. It remembers a few answers, so that
  /// only one thread may call it.
  bool corner_faces(std::uint32_t index, int k, const narrowphase::Vec3& direction) const;

  /// Returns the triangle that holds a point in the plane of another triangle, if the surface goes
  /// on flat from that to there.
  std::optional<std::uint32_t> flat_triangle(std::uint32_t index, const narrowphase::Core& triangle,
                                             const narrowphase::Vec3& point) const;

  /// True if the surface, on its way from a triangle to a point in its plane, falls back behind
  /// that plane where it ceases to be flat.
  bool falls_back(std::uint32_t index, const narrowphase::Core& triangle,
                  const narrowphase::Vec3& point) const;

  /// Returns the triangle beyond the edge from corner k to the next; nothing where the surface
  /// ends.
  std::optional<std::uint32_t> across(std::uint32_t index, int k) const;

  /// Returns a triangle in the form that the solvers take.
  narrowphase::Core placed_triangle(std::uint32_t index) const;

  /// Returns the triangles around a welded vertex.
  std::span<const std::uint32_t> fan(std::uint32_t vertex) const;

  /// Returns the number of a corner among welded vertices.
  std::uint32_t vertex(std::uint32_t index, int k) const;

 private:
  /// Narrows the directions that an edge faces by the triangles beside it.
  class Narrowing;

  /// The last of the flat triangles on the way to a point, and what is beyond it.
  struct FlatWay {
    std::uint32_t last;
    bool has_point = false;
    std::optional<std::uint32_t> beyond;  ///< nothing where the surface ends, or at the point
  };

  FlatWay flat_way(std::uint32_t index, const narrowphase::Core& first,
                   const narrowphase::Vec3& point) const;
  narrowphase::Vec3 placed(std::uint32_t vertex) const;
  bool vertex_faces(std::uint32_t of, const narrowphase::Vec3& direction) const;
  std::optional<std::uint32_t> neighbour(std::uint32_t s, std::uint32_t t,
                                         std::uint32_t without) const;
  /// An end of an edge: a vertex and its place.
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

  /// An answer of corner_faces(). Thousands of triangles may share a corner, and ask the same about
  /// it.
  struct AskedCorner {
    std::uint32_t vertex = 0xffffffffu;
    narrowphase::Vec3 direction;
    bool is_faced = false;
  };
  mutable std::array<AskedCorner, 8> asked_;
};

}  // namespace graze

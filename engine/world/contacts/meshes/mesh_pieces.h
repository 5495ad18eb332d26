#pragma once

// Finds the pieces of what two meshes have in common. Private to engine/world.

#include <graze/engine/world/contacts/meshes/inner_surface.h>
#include <graze/engine/world/contacts/meshes/mesh_crossings.h>
#include <graze/engine/world/contacts/meshes/point_numbers.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze {

/// The area that a closed curve encloses, as far as it is flat, and the normals along it.
struct Outline {
  narrowphase::Vec3 first;  ///< any point of the curve
  narrowphase::Vec3 area;
  narrowphase::Vec3 faces_a;  ///< the sum of A's normals, weighted by the lengths of segments;
                              ///< faces_b is that of B's
  narrowphase::Vec3 faces_b;
  double around = 0;

  /// Returns the normal from A to B: that of the area, or the mean of the faces' normals if the
  /// area is too small; zero where nothing tells it.
  narrowphase::Vec3 normal() const;
  /// Returns how much the faces of one mesh look to one side: 1 if all do, 0 if they look to all
  /// sides alike, as those of a thread or of a peg.
  double together(bool faces_are_a) const;
};

/// The pieces: for each the crossings that bound it, and the parts of either mesh that lie in it.
/// Memory is kept from one pair to the next.
class MeshPieces {
 public:
  enum class Found {
    Nothing,  ///< the two are apart
    Touches,  ///< the two touch in planes, along lines or in points: crossings do not tell
    Pieces,
  };

  /// Finds the pieces of two meshes, which must outlive this. Points are relative to the origin.
  Found find(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
             const narrowphase::Vec3& origin, Work& work);

  std::uint32_t count() const { return found_.pieces; }
  std::span<const MeshCrossing> crossings(std::uint32_t piece) const;
  const Outline& outline(std::uint32_t piece) const { return outlines_[piece]; }
  /// True if nearly all along the curves of a piece a face of one mesh or the other looks one way,
  /// as where a wide body lies across a narrow one: the top of the one or the bottom of the other.
  bool is_left_one_way(std::uint32_t piece) const;
  InnerPart& inner_a(std::uint32_t piece) { return inner_a_.part(piece); }
  InnerPart& inner_b(std::uint32_t piece) { return inner_b_.part(piece); }
  InnerSurface& surface(InnerSide side) { return side == InnerSide::OfA ? inner_a_ : inner_b_; }

  const Pose& pose_a() const { return mesh_a_->pose; }
  const Pose& pose_b() const { return mesh_b_->pose; }

  /// Returns by how much A's box is larger than B's, each in its own frame, or for equal boxes how
  /// many more triangles A has; negative if B is the larger one.
  double larger() const;

  /// Returns the scale of lengths: how far the pieces reach from the origin.
  double size();

  /// Removes the pairs whose triangles are apart once A has moved. It is fastest if successive
  /// pairs have the same triangle of A.
  void remove_apart(std::vector<TrianglePair>& pairs, const narrowphase::Vec3& translation,
                    Work& work) const;

 private:
  template <typename NumberOf>
  void find_outlines(std::uint32_t count, NumberOf&& number_of);
  void join_holes();

  const PlacedMeshView* mesh_a_ = nullptr;
  const PlacedMeshView* mesh_b_ = nullptr;
  narrowphase::Vec3 origin_;
  MeshCrossings found_;
  InnerSurface inner_a_, inner_b_;
  std::vector<Outline> outlines_;  ///< the outlines of loops, then of pieces
  std::vector<std::uint32_t> largest_loop_;
  std::vector<std::size_t> ends_;  ///< the end of the crossings of each piece
  LoopGroups groups_;
  PointNumbers numbers_;
};

}  // namespace graze

#pragma once

// Finds the part of one mesh near a triangle of the other. Private to engine/world.

#include <graze/engine/world/contacts/meshes/inner_surface.h>
#include <graze/engine/world/contacts/meshes/piece_index.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze {

/// The part of a mesh's inner surface that one triangle of the other mesh meets: the inner parts of
/// the triangles that go through it, and the points to which the surface rises from there in a
/// direction. Where a piece wraps around a body, as a thread does, this part has to leave the
/// triangle. Memory is kept from one triangle to the next.
class LocalPart {
 public:
  /// Begins with a triangle that crosses in the index's piece; `surface` is that of the other mesh.
  /// All must outlive it. The surface is followed until it has risen by `most_rise`.
  void start(const InnerSurface& surface, const PieceIndex& index, std::uint32_t piece,
             std::uint32_t triangle, InnerSide side, double most_rise);

  /// Adds the points to which the surface rises inside without a stop. Returns the number of the
  /// farthest point.
  std::size_t grow(const narrowphase::Vec3& direction);

  /// True if in some direction the surface rose farther than that, or went on outside around the
  /// other mesh: then it has no end near the triangle.
  bool goes_on() const { return goes_on_; }

  const InnerPart& part() const { return part_; }

 private:
  void add_curve_point(std::uint32_t point, const narrowphase::Vec3& at);
  void add_vertex(std::uint32_t vertex);
  bool add_corners(std::uint32_t own_triangle, const narrowphase::Vec3& direction, double above);
  void add_ends(std::span<const std::uint32_t> crossings, const narrowphase::Vec3& direction,
                double above);
  void go_on_inside(std::size_t point, const narrowphase::Vec3& direction);
  bool rises_outside(std::size_t point, const narrowphase::Vec3& direction) const;

  const InnerSurface* surface_ = nullptr;
  const PieceIndex* index_ = nullptr;
  bool is_of_a_ = false;  ///< whether it is A's surface
  double most_rise_ = 0;
  bool goes_on_ = false;
  InnerPart part_;
  std::vector<std::uint32_t> curve_point_;  ///< the curve's point of each point of the part without
                                            ///< a vertex
  std::uint64_t round_ = 0;
  std::vector<std::uint64_t> point_round_;   ///< the round in which each point of the curves was
                                             ///< added last
  std::vector<std::uint64_t> vertex_round_;  ///< the round in which each vertex was added last
};

}  // namespace graze

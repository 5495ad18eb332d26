#pragma once

#include <graze/engine/mesh/mesh.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <cstdint>
#include <span>
#include <vector>

namespace graze::mesh_io {

/// Cuts polygons into triangles. It keeps its working memory from one polygon to the next.
///
/// It tries in this order: a fan from the first corner if all its triangles turn the same way (a
/// convex polygon); ear clipping if it comes to an end (any other simple polygon, also one with
/// holes that are joined to its outline by an edge walked twice, with repeated corners or with
/// spikes); otherwise, for a polygon that crosses itself or has no area, again the fan: such a
/// polygon has no inside to keep to, but every corner stays covered.
///
/// Turns are decided exactly, in the projection onto the coordinate plane in which the polygon's
/// area is largest.
class Triangulator {
 public:
  /// Writes the corners.size() - 2 triangles. There must be at least 3 corners, each of them an
  /// index into `vertices`, which must be finite. It takes linear time for a fan, quadratic time
  /// for ear clipping.
  void triangulate(std::span<const Eigen::Vector3d> vertices,
                   std::span<const std::uint32_t> corners, std::span<TriangleIndices> triangles);

 private:
  /// The corners of one triangle, counted from 0 along the outline.
  using Cut = std::array<std::uint32_t, 3>;

  bool is_fan_of_one_turn() const;
  void mirror();
  bool clip_ears();
  void link();
  std::uint32_t cut_folds(std::uint32_t& left);
  void mark_ears(std::uint32_t corner, std::uint32_t left);
  bool find_corner_to_cut(std::uint32_t& corner, std::uint32_t left) const;
  void unlink(std::uint32_t corner);
  void cut_off(std::uint32_t corner);
  bool is_fold(std::uint32_t corner) const;
  narrowphase::Sign turn(std::uint32_t corner) const;
  bool is_ear(std::uint32_t corner) const;
  bool blocks(std::uint32_t corner, const Cut& cut) const;

  std::vector<narrowphase::Point2> points_;
  std::vector<std::uint32_t> previous_;
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t>
      blockers_;  ///< corners that do not turn left: no others can block an ear
  std::vector<bool> is_ear_;
  std::vector<Cut> cuts_;
};

}  // namespace graze::mesh_io

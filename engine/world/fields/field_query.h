#pragma once

// What of a height field something else may come near. Private to engine/world.

#include <graze/bvh/pose.h>
#include <graze/engine/world/fields/field_data.h>
#include <graze/engine/world/placed_shape.h>

#include <vector>

namespace graze {

/// Something beside a field, in the field's frame: a box around it, which may go straight, or a
/// half-space. Outward: what the placed triangles of a square may come to, the square's box does.
class FieldQuery {
 public:
  /// A box in the world.
  FieldQuery(const HeightFieldData& field, const Pose& pose, const Aabb& box);
  /// The box around a placed shape, or a half-space.
  FieldQuery(const HeightFieldData& field, const Pose& pose, const PlacedShapeView& other);

  /// All that is so far away counts as well, metres.
  void grow(double room);
  /// So far aside, for all heights that are as far away.
  void grow_aside(double room);
  /// The box goes, metres in the world; relative to the field.
  void move(const Pose& pose, const Eigen::Vector3d& displacement);

  /// Whether it may come to what is in a box of the field's frame.
  bool meets(const Aabb& box) const;
  /// A lower bound of how far it is from that, metres; 0 if it meets it. Of what does not go.
  double distance(const Aabb& box) const;

  /// The cells that it is above or below, with all around these. Of a half-space all.
  CellRect columns_of_cells(const HeightFieldData& field) const;

 private:
  double height_above(const Aabb& box) const;
  double gap_to(const Aabb& box) const;

  bool is_plane_ = false;
  Aabb box_{};       ///< with all room
  Aabb inner_{};     ///< without that of grow(),
  double room_ = 0;  ///< which is so much, in all directions: corners of the box are farther
  Eigen::Vector3d displacement_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();  ///< of a half-space
  double offset_ = 0;
  double pad_ = 0;
};

/// Whether any cell that is no hole is in a square that it meets.
bool is_any_met(const HeightFieldData& field, const FieldQuery& query);

/// The squares of level 0 with a cell that it meets, row by row.
std::vector<CellSquare> squares_met(const HeightFieldData& field, const FieldQuery& query);

/// The square of level 0 that is nearest to it; never one of holes alone.
CellSquare nearest_square(const HeightFieldData& field, const FieldQuery& query);

}  // namespace graze

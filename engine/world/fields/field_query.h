#pragma once

// Finds the cells of a height field that something else may come near. Private to engine/world.

#include <graze/bvh/pose.h>
#include <graze/engine/world/fields/field_data.h>
#include <graze/engine/world/placed_shape.h>

#include <vector>

namespace graze {

/// A shape beside a field, in the field's frame: a box around it, which may go straight, or a
/// half-space. It is rounded outward: if the placed triangles of a square may come to the shape,
/// the square's box meets this.
class FieldQuery {
 public:
  /// Takes a box in the world.
  FieldQuery(const HeightFieldData& field, const Pose& pose, const Aabb& box);
  /// Takes the box around a placed shape, or a half-space.
  FieldQuery(const HeightFieldData& field, const Pose& pose, const PlacedShapeView& other);

  /// Makes all that is so far away count as well, metres.
  void grow(double room);
  /// Makes cells so far aside count as well, metres, up to heights that are as far away.
  void grow_aside(double room);
  /// Lets the box go along a displacement relative to the field, metres in the world.
  void move(const Pose& pose, const Eigen::Vector3d& displacement);

  /// True if it may come to the contents of a box of the field's frame.
  bool meets(const Aabb& box) const;
  /// Returns a lower bound of its distance from such contents, metres; 0 if it meets the box. It
  /// must not move.
  double distance(const Aabb& box) const;

  /// Returns the cells that it is above or below, with those around them; for a half-space all
  /// cells.
  CellRect columns_of_cells(const HeightFieldData& field) const;

 private:
  double height_above(const Aabb& box) const;
  double gap_to(const Aabb& box) const;

  bool is_plane_ = false;
  Aabb box_{};       ///< the box with all room
  Aabb inner_{};     ///< the box without the room of grow()
  double room_ = 0;  ///< the room of grow(), in all directions: corners of the box are farther
  Eigen::Vector3d displacement_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();  ///< the normal of a half-space
  double offset_ = 0;
  double pad_ = 0;
};

/// True if any cell that is no hole is in a square that the query meets.
bool is_any_met(const HeightFieldData& field, const FieldQuery& query);

/// Returns the squares of level 0 with a cell that the query meets, row by row.
std::vector<CellSquare> squares_met(const HeightFieldData& field, const FieldQuery& query);

/// Returns the square of level 0 that is nearest to the query; never one with holes only.
CellSquare nearest_square(const HeightFieldData& field, const FieldQuery& query);

}  // namespace graze

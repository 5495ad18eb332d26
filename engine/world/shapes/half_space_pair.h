#pragma once

// Half-spaces that stand for two-sided planes in one question. Private to engine/world.

#include <graze/engine/work.h>
#include <graze/engine/world/placed_shape.h>

#include <array>
#include <cstddef>
#include <optional>

namespace graze {

inline bool is_plane(const PlacedShapeView& s) {
  return s.shape.kind() == ShapeKind::Plane;
}
inline bool has_plane(const PlacedShapeView& a, const PlacedShapeView& b) {
  return is_plane(a) || is_plane(b);
}

/// A pair of which one is a plane, or both, as a pair with half-spaces: a plane touches what is in
/// one piece exactly if both of its half-spaces do, and what touches one alone is as far from the
/// plane as from the other. So the half-space stands for it which the other one does not touch, or
/// else which it leaves by the shorter way: what the question says of that one is the answer. Where
/// both do, the one behind the normal.
///
/// A mesh with pieces on both sides, none of which crosses the plane, is divided: then there are
/// two pairs, which are apart, the pieces on either side and the half-space behind the plane as
/// seen from there. Patches of the mesh, they have its bounds and numbers.
class HalfSpacePair {
 public:
  /// Both must outlive this. Throws UnsupportedPairError for a height field with holes that reaches
  /// to both sides: whether it is in pieces nothing tells short of a mesh of all its cells.
  HalfSpacePair(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);

  /// 1, or 2 where a mesh is divided.
  std::size_t count() const { return is_divided_ ? 2 : 1; }
  bool is_divided() const { return is_divided_; }
  PlacedShapeView a(std::size_t i = 0) const { return a_.view(i); }
  PlacedShapeView b(std::size_t i = 0) const { return b_.view(i); }

 private:
  struct Side {
    const PlacedShapeView own;
    std::array<std::optional<Shape>, 2> by = {};  ///< what stands for it, if something does

    PlacedShapeView view(std::size_t i) const { return {by[i] ? *by[i] : own.shape, own.pose}; }
  };

  void choose(Side& plane, Side& other, Work& work);
  void choose_beside_mesh(Side& plane, Side& mesh, const Shape& front, const Shape& back,
                          Work& work);
  void choose_beside_field(Side& plane, Side& field, const Shape& front, const Shape& back,
                           Work& work);

  Side a_, b_;
  bool is_divided_ = false;
};

/// A point of both, in the world, of two of which one is a plane, or both, and that touch; `known`
/// is a point of the one that is no plane, or on both of two planes.
Eigen::Vector3d point_in_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                               const Eigen::Vector3d& known, Work& work);

/// Where the other shape is above the plane, or leaves it upwards: the points below the normal.
HalfSpace front_of(const Plane& plane);
/// The points above it.
HalfSpace back_of(const Plane& plane);

}  // namespace graze

#pragma once

// Replaces two-sided planes by half-spaces for one question. Private to engine/world.

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

/// A pair with one plane, or two, as a pair with half-spaces. A plane touches a shape in one piece
/// exactly if both of its half-spaces do, and a shape that touches only one of them is as far from
/// the plane as from the other. So the plane is replaced by the half-space that the other shape
/// does not touch, or else by the one that it leaves by the shorter way: the answer for that
/// half-space is the answer for the plane. If either would do, the half-space behind the normal is
/// taken.
///
/// A mesh with pieces on both sides, none of which crosses the plane, is divided: then there are
/// two pairs, which are apart, each of the pieces on one side and the half-space behind the plane
/// as seen from there. The pieces are patches of the mesh, with its bounds and numbers. A height
/// field with holes that reaches to both sides may be in pieces, too, and is asked as a mesh.
class HalfSpacePair {
 public:
  /// Makes the pair; both shapes must outlive it.
  HalfSpacePair(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);

  /// Returns the number of pairs: 1, or 2 if a mesh is divided.
  std::size_t count() const { return is_divided_ ? 2 : 1; }
  bool is_divided() const { return is_divided_; }
  PlacedShapeView a(std::size_t i = 0) const { return a_.view(i); }
  PlacedShapeView b(std::size_t i = 0) const { return b_.view(i); }

 private:
  struct Side {
    const PlacedShapeView own;
    std::array<std::optional<Shape>, 2> by = {};  ///< the shapes that replace it, if any do

    PlacedShapeView view(std::size_t i) const { return {by[i] ? *by[i] : own.shape, own.pose}; }
  };

  void choose(Side& plane, Side& other, Work& work);
  void choose_beside_mesh(Side& plane, Side& other, const Mesh& mesh, const Shape& front,
                          const Shape& back, Work& work);
  void choose_beside_field(Side& plane, Side& field, const Shape& front, const Shape& back,
                           Work& work);

  Side a_, b_;
  bool is_divided_ = false;
};

/// Returns a point of both shapes, in the world, for a pair with one plane, or two, that touches;
/// `known` is a point of the shape that is no plane, or of both if both are planes.
Eigen::Vector3d point_in_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                               const Eigen::Vector3d& known, Work& work);

/// Returns the half-space of the points below the plane, which stands for it where the other shape
/// is above, or leaves it upwards.
HalfSpace front_of(const Plane& plane);
/// Returns the half-space of the points above the plane.
HalfSpace back_of(const Plane& plane);

}  // namespace graze

#pragma once

#include <cstdint>

namespace graze {

/// Says what counts as a part of a mesh, beside its surface, for contacts.
enum class Sides : std::uint8_t {
  Surface,  ///< only the surface counts: a body that touches it leaves it in front, and a body
            ///< inside touches nothing
  Solid,  ///< the inside counts as well, and a body there leaves by the nearest way. The mesh must
          ///< be closed, each edge must have as many triangles one way as the other, and fronts
          ///< must be outside: check() lists parts that are inside out
  OneSided  ///< space behind the surface counts, too, up to a thickness, and is left in front or
            ///< past a border. No edge may have two more triangles one way than the other
};

/// The sides of a mesh that count, with their thickness. Shapes that are no meshes can only have
/// surface(), but a height field can have one_sided(), too.
class MeshSides {
 public:
  /// Makes the same as surface().
  constexpr MeshSides() = default;

  /// Returns sides of which nothing counts beside the surface.
  static constexpr MeshSides surface() { return {}; }
  /// Returns sides of which the inside of the mesh counts as well.
  static constexpr MeshSides solid() { return {Sides::Solid, 0}; }
  /// Returns sides of which the space behind the surface counts as well. `thickness` says how far
  /// behind the surface the nearest point of a body may be: metres, finite and above 0, or the
  /// queries and worlds that are given it throw InputError.
  static constexpr MeshSides one_sided(double thickness) { return {Sides::OneSided, thickness}; }

  /// Returns which of these it is.
  constexpr Sides kind() const { return kind_; }
  /// Returns the thickness, metres; it is 0 unless one-sided.
  constexpr double thickness() const { return thickness_; }

  constexpr bool operator==(const MeshSides&) const = default;

 private:
  constexpr MeshSides(Sides kind, double thickness) : kind_(kind), thickness_(thickness) {}

  Sides kind_ = Sides::Surface;
  double thickness_ = 0;  ///< metres
};

}  // namespace graze

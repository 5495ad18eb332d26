#pragma once

#include <cstdint>

namespace graze {

/// What counts as a part of a mesh, beside its surface, where contacts are asked for.
enum class Sides : std::uint8_t {
  Surface,  ///< only the surface: a body that touches it leaves it in front, and a body inside
            ///< touches nothing
  Solid,  ///< the inside as well: a body there leaves by the nearest way. The mesh must be closed,
          ///< and each edge must have as many triangles one way as the other
  OneSided  ///< the space behind the surface as well, up to a thickness: a body there leaves in
            ///< front. No edge may have two more triangles one way than the other
};

/// The sides of a mesh that count, with their thickness. Shapes that are no meshes can only have
/// surface(), but a height field can have one_sided(), too.
class MeshSides {
 public:
  /// The same as surface().
  constexpr MeshSides() = default;

  /// Nothing counts beside the surface.
  static constexpr MeshSides surface() { return {}; }
  /// What is inside the mesh counts as well.
  static constexpr MeshSides solid() { return {Sides::Solid, 0}; }
  /// `thickness` says how far behind the surface the nearest point of a body may be: metres, finite
  /// and above 0, or the queries and worlds that are given it throw InputError.
  static constexpr MeshSides one_sided(double thickness) { return {Sides::OneSided, thickness}; }

  /// What counts.
  constexpr Sides kind() const { return kind_; }
  /// Metres; 0 unless one-sided.
  constexpr double thickness() const { return thickness_; }

  constexpr bool operator==(const MeshSides&) const = default;

 private:
  constexpr MeshSides(Sides kind, double thickness) : kind_(kind), thickness_(thickness) {}

  Sides kind_ = Sides::Surface;
  double thickness_ = 0;  ///< metres
};

}  // namespace graze

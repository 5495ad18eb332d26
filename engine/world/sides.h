#pragma once

#include <cstdint>

namespace graze {

/// What of a mesh counts where contacts are asked for, beside its surface.
enum class Sides : std::uint8_t {
  Surface,  ///< nothing: what touches it leaves it in front, and what is inside touches nothing
  Solid,    ///< what is inside as well, which leaves by the nearest way. The mesh is closed, and
            ///< each edge has as many triangles one way as the other
  OneSided  ///< what is behind it as well, up to a thickness, which leaves in front. No edge has
            ///< two more triangles one way than the other
};

/// Says which sides of a mesh count, and up to which thickness. Other shapes than meshes have a
/// surface() only, and a height field is never solid().
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

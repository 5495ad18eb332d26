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

/// The same with its thickness. Of other shapes than meshes only Surface is possible, and of
/// height fields no Solid.
struct MeshSides {
  Sides sides = Sides::Surface;  ///< what counts
  /// Metres, of OneSided: finite and above 0; of the others 0. How far behind the surface the
  /// nearest point of a body may be.
  double thickness = 0;

  bool operator==(const MeshSides&) const = default;
};

}  // namespace graze

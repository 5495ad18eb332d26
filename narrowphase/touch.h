#pragma once

namespace graze {

/// Which pairs of triangles a query counts.
enum class Touch {
  /// All that share a point (law 2): touching counts.
  Include,
  /// Only those of which crosses() is true: their relative interiors meet, and they do not lie in
  /// one plane. What
  /// merely touches, in a vertex, along an edge or face on face, is left out. It speaks of pairs of
  /// triangles and claims nothing about solids: two equal boxes in one pose overlap wholly, and
  /// hardly any of their triangles cross.
  Exclude,
};

}  // namespace graze

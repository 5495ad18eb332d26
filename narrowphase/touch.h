#pragma once

namespace graze {

/// Says which pairs of triangles a query counts.
enum class Touch {
  /// All pairs that share a point count (law 2), touching ones too.
  Include,
  /// Only pairs of which crosses() is true count: their relative interiors meet, and they do not
  /// lie in one plane. What merely touches, in a vertex, along an edge or face on face, is left
  /// out. This is a statement about pairs of triangles, not about solids: two equal boxes in one
  /// pose overlap wholly, and hardly any of their triangles cross.
  Exclude,
};

}  // namespace graze

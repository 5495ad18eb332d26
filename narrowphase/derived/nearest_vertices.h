#pragma once

#include <graze/narrowphase/triangle_distance.h>

namespace graze::narrowphase {

/// Keeps two vertices that are nearest in a known pair of triangles, and so in most other pairs
/// that have them: of six triangles around either, thirty-six pairs are as far apart.
class NearestVertices {
 public:
  /// Takes what decide_distance() found. Nothing is known where other features are nearest, or
  /// where another stage might round the distance otherwise.
  void set(const TriangleDistance& found);

  /// Returns what was found, if it surely is what decide_distance() answers for these triangles,
  /// bit for bit, and null if that is not sure. The pointer is valid until the next set().
  const TriangleDistance* of(const Triangle& triangle_a, const Triangle& triangle_b) const;

 private:
  bool is_known_ = false;
  TriangleDistance found_{};
};

}  // namespace graze::narrowphase

#pragma once

// Bounds the distances of balls, boxes and meshes without a search. Private to engine/world.

#include <graze/engine/world/shapes/pair_input.h>

namespace graze {

/// One shape of a pair, and a length than which no point of it is farther from its frame's origin.
struct BoundedShape {
  const Shape& shape;
  const Pose& pose;
  double bounding_radius;
};

/// True for pairs whose gap costs about as much as their test: balls and boxes, among themselves
/// and with meshes.
bool is_gap_quick(PairMethod method);

/// Returns a bound as BodyShape::gap() does for two balls or boxes; 0 for all others, and where the
/// formula proves nothing. It is less than the distance: for two boxes mostly a third of that.
double quick_gap(const BoundedShape& a, const BoundedShape& b);

/// Returns a lower bound of the distance of a ball or a box, A, from the triangles of a mesh, B.
double mesh_distance_bound(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);

}  // namespace graze

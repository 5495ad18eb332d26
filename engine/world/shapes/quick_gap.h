#pragma once

// How far apart balls, boxes and meshes are at least, without a search. Private to engine/world.

#include <graze/engine/world/shapes/pair_input.h>

namespace graze {

/// One side of a pair, and how far from its frame's origin its points are at most.
struct BoundedShape {
  const Shape& shape;
  const Pose& pose;
  double bounding_radius;
};

/// True for pairs whose gap costs about as much as their test: balls and boxes, among themselves
/// and with meshes.
bool is_gap_quick(PairMethod method);

/// As BodyShape::gap(), of two that are balls or boxes; 0 of any others, and where the formula
/// proves nothing. Not the distance: of two boxes mostly a third of that.
double quick_gap(const BoundedShape& a, const BoundedShape& b);

/// Of the distance of a ball or a box, A, from the triangles of a mesh, B: not more than that.
double mesh_distance_bound(const PlacedShapeView& a, const PlacedShapeView& b, Work& work);

}  // namespace graze

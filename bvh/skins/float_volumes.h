#pragma once

#include <graze/bvh/kdop.h>

namespace graze::bvh {

// The volumes that a skin holds for each node of a tree, in the tree's LocalFrame and rounded
// outward (law 5), as FloatBox is.

/// A closed ball.
struct FloatSphere {
  float centre[3];
  float radius;
};

/// A closed box whose axes are a rotation's, known to float: axis i is axes[i] but for an error of
/// kAxisError in each component.
struct FloatObb {
  float axes[3][3];
  float centre[3];
  float half[3];

  static constexpr double kAxisError = 0x1p-24;
};

/// The polytope of the slabs min <= p . kKDopDirections<18> <= max.
struct FloatKDop {
  float min[KDop<18>::kSlabs];
  float max[KDop<18>::kSlabs];
};

}  // namespace graze::bvh

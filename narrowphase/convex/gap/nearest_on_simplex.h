#pragma once

#include <graze/narrowphase/convex/core/vector.h>

namespace graze::narrowphase {

/// Holds up to four points of the difference of two sets, each with the points that it came from.
struct DifferenceSimplex {
  Vec3 point[4];
  Vec3 from_a[4];
  Vec3 from_b[4];
  double weight[4];
  int count = 0;
};

/// The point of a simplex nearest to the origin, and the direction to it, of any length. Where the
/// point lies in a face the direction is that of the face's normal, which is better known than the
/// point if that is near.
struct NearestPoint {
  Vec3 point;
  Vec3 direction;
};

enum class OriginSide { Outside, Inside };

/// Reduces the simplex to the smallest one that holds its point nearest to the origin, with that
/// point's weights, none of them negative and 1 in sum, and hands the point back in `nearest`. The
/// answer is Inside if four points hold the origin among them, which then has their weights. All
/// faces are looked at, so that a flat simplex costs accuracy but makes no answer absurd: the point
/// is no further than that of any edge.
OriginSide reduce_to_nearest(DifferenceSimplex& simplex, NearestPoint& nearest);

}  // namespace graze::narrowphase

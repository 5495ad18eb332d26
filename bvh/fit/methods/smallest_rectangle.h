#pragma once

#include <vector>

namespace graze::bvh {

struct PlanePoint {
  double x;
  double y;
};

/// Returns the direction of one side, at length 1, of the smallest rectangle around the points,
/// which are reordered. `padding` is added to both sides before their product is taken, so that
/// collinear points get the direction of their line. It is {1, 0} if all points are one. It takes
/// O(n log n): one side lies on an edge of the convex hull (Freeman, Shapira, 1975), and callipers
/// turn once around it (Toussaint, 1983).
PlanePoint smallest_rectangle_side(std::vector<PlanePoint>& points, double padding);

}  // namespace graze::bvh

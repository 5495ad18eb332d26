#pragma once

#include <vector>

namespace graze::generator {

struct CirclePoint {
  double x;
  double y;
};

/// 4 * 2^halvings points around the unit circle, counter-clockwise from (1, 0), by halving angles
/// with square roots: the same on every machine, and mirrored exactly by both axes and diagonals.
std::vector<CirclePoint> unit_circle(int halvings);

}  // namespace graze::generator

#pragma once

#include <vector>

#include "data/generator/surface.h"

namespace graze::generator {

/// A point of a column. `section` and `line` say which line around the axis it lies on; along a
/// column they ascend in this order. Lengths in millimetres.
struct ColumnPoint {
  int section;
  int line;
  double r;
  double z;
};

/// The outline of the solid in the half-plane of one angle, the material to its left when r points
/// right and z points up. It runs from pole to pole, or ends where it begins.
using Column = std::vector<ColumnPoint>;

/// One section winds around the axis: after a turn its line n has become line n + lines_per_turn.
struct Winding {
  int section;
  int lines_per_turn;
};

/// Joins columns at equal angles around z into a closed surface. Neighbouring columns are joined
/// along the lines that both have; a line that only one of them has ends in a triangle.
/// Why this is a clean manifold: both columns are walked once from end to end, each step adds one
/// triangle on the edge that the step before left, and each column is walked once from either side.
Surface turn_on_lathe(const std::vector<Column>& columns, const Winding& winding);

}  // namespace graze::generator

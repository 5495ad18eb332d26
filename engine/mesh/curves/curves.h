#pragma once

#include <cstdint>
#include <vector>

#include <graze/engine/mesh/curves/cell_complex.h>

namespace graze::contacts {

/// A segment of a complex on a curve, in the sense in which the curve runs.
struct CurveStep {
  std::uint32_t segment;
  std::uint32_t from;
  std::uint32_t to;
};

/// A curve: segments end to end.
using CurveSteps = std::vector<CurveStep>;

/// Chains the segments that bound no polygon. A curve runs on through a node where just two of them
/// meet and no polygon does, and ends at all others, or where it began. It starts at its lowest
/// node, or lower end, and runs towards the lower neighbour; curves ascend by their nodes.
std::vector<CurveSteps> chain_curves(const CellComplex& complex);

/// Returns for each node whether a polygon has it as a corner.
std::vector<bool> corners_of_polygons(const CellComplex& complex);

/// Returns for each segment whether it is an edge of a polygon.
std::vector<bool> edges_of_polygons(const CellComplex& complex);

/// True if a curve ends where it began.
inline bool is_closed(const CurveSteps& curve) {
  return curve.front().from == curve.back().to;
}

}  // namespace graze::contacts

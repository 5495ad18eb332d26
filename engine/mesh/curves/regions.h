#pragma once

#include <cstdint>
#include <vector>

#include <graze/engine/mesh/curves/cell_complex.h>
#include <graze/engine/mesh/curves/curves.h>

namespace graze::contacts {

/// What is connected of an intersection: a loop, or some loops and patches that meet, or a point.
struct Region {
  std::vector<std::uint32_t> nodes;     ///< all ascending
  std::vector<std::uint32_t> points;    ///< cells of the complex
  std::vector<std::uint32_t> segments;  ///< of the complex; those that bound polygons, too
  std::vector<std::uint32_t> polygons;
  std::vector<std::uint32_t> curves;
  bool has_loose_end = false;  ///< whether a curve ends in a node where nothing else begins
};

/// In the order of their lowest nodes.
std::vector<Region> find_regions(const CellComplex& complex, const std::vector<CurveSteps>& curves);

}  // namespace graze::contacts

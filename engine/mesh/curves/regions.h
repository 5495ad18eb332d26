#pragma once

#include <cstdint>
#include <vector>

#include <graze/engine/mesh/curves/cell_complex.h>
#include <graze/engine/mesh/curves/curves.h>

namespace graze::contacts {

/// A connected piece of an intersection: a loop, or some loops and patches that meet, or a point.
struct Region {
  std::vector<std::uint32_t> nodes;     ///< all nodes, ascending
  std::vector<std::uint32_t> points;    ///< points of the complex, by their indices
  std::vector<std::uint32_t> segments;  ///< segments of the complex; those that bound polygons, too
  std::vector<std::uint32_t> polygons;
  std::vector<std::uint32_t> curves;
  bool has_loose_end = false;  ///< whether a curve ends in a node where nothing else begins
};

/// Finds all regions, in the order of their lowest nodes.
std::vector<Region> find_regions(const CellComplex& complex, const std::vector<CurveSteps>& curves);

}  // namespace graze::contacts

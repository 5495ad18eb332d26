#include <graze/engine/mesh/curves/disjoint_sets.h>
#include <graze/engine/mesh/curves/regions.h>

namespace graze::contacts {
namespace {

DisjointSets connected_nodes(const CellComplex& complex) {
  DisjointSets sets(complex.nodes.size());
  for (const std::vector<Cell>* cells : {&complex.segments, &complex.polygons}) {
    for (const Cell& cell : *cells) {
      for (std::uint32_t i = 1; i < cell.count; ++i)
        sets.join(cell.corner[0], cell.corner[i]);
    }
  }
  return sets;
}

/// Returns for each node whether one end of one curve is all that is there.
std::vector<bool> loose_ends(const CellComplex& complex, const std::vector<CurveSteps>& curves) {
  std::vector<int> ends(complex.nodes.size());
  for (const CurveSteps& curve : curves) {
    ++ends[curve.front().from];
    ++ends[curve.back().to];
  }
  const std::vector<bool> is_corner = corners_of_polygons(complex);
  std::vector<bool> is_loose(complex.nodes.size());
  for (std::size_t i = 0; i < ends.size(); ++i)
    is_loose[i] = ends[i] == 1 && !is_corner[i];
  return is_loose;
}

}  // namespace

std::vector<Region> find_regions(const CellComplex& complex,
                                 const std::vector<CurveSteps>& curves) {
  DisjointSets sets = connected_nodes(complex);
  const std::vector<bool> is_loose = loose_ends(complex, curves);
  std::vector<Region> regions;
  std::vector<std::uint32_t> region_of(complex.nodes.size());
  for (std::uint32_t node = 0; node < complex.nodes.size(); ++node) {
    const std::uint32_t lowest = sets.lowest(node);
    if (lowest == node) {
      region_of[node] = static_cast<std::uint32_t>(regions.size());
      regions.emplace_back();
    }
    region_of[node] = region_of[lowest];
    regions[region_of[node]].nodes.push_back(node);
    if (is_loose[node]) regions[region_of[node]].has_loose_end = true;
  }
  const auto share_out = [&](const std::vector<Cell>& cells, auto Region::*list) {
    for (std::uint32_t i = 0; i < cells.size(); ++i)
      (regions[region_of[cells[i].corner[0]]].*list).push_back(i);
  };
  share_out(complex.points, &Region::points);
  share_out(complex.segments, &Region::segments);
  share_out(complex.polygons, &Region::polygons);
  for (std::uint32_t i = 0; i < curves.size(); ++i)
    regions[region_of[curves[i].front().from]].curves.push_back(i);
  return regions;
}

}  // namespace graze::contacts

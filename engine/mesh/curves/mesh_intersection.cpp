#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/curves/cell_complex.h>
#include <graze/engine/mesh/curves/curves.h>
#include <graze/engine/mesh/curves/disjoint_sets.h>
#include <graze/engine/mesh/mesh_intersection.h>

#include <algorithm>
#include <map>
#include <utility>

namespace graze {
namespace {

using contacts::Cell;
using contacts::CellComplex;

Feature feature_of(const contacts::FeatureName& name) {
  return name.is_vertex() ? Feature::Vertex : name.is_edge() ? Feature::Edge : Feature::Face;
}

std::uint32_t size_of(const auto& list) {
  return static_cast<std::uint32_t>(list.size());
}

void add_points(const CellComplex& complex, MeshIntersection& result) {
  for (const contacts::Node& node : complex.nodes) {
    result.points.push_back({node.position, feature_of(node.name.a), feature_of(node.name.b)});
  }
}

void add_curves(const CellComplex& complex, MeshIntersection& result) {
  for (const contacts::CurveSteps& curve : contacts::chain_curves(complex)) {
    result.curves.push_back({size_of(result.segments), size_of(curve), contacts::is_closed(curve)});
    for (const contacts::CurveStep& step : curve) {
      const Cell& cell = complex.segments[step.segment];
      result.segments.push_back({step.from, step.to, cell.first_pair, cell.pair_count});
    }
  }
}

/// Returns for each polygon the lowest one of its patch.
std::vector<std::uint32_t> patches_of(const CellComplex& complex) {
  contacts::DisjointSets sets(complex.polygons.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> by_edge;
  for (std::uint32_t i = 0; i < complex.polygons.size(); ++i) {
    const Cell& cell = complex.polygons[i];
    for (std::uint32_t k = 0; k < cell.count; ++k) {
      const auto edge = std::minmax(cell.corner[k], cell.corner[(k + 1) % cell.count]);
      sets.join(i, by_edge.try_emplace(edge, i).first->second);
    }
  }
  std::vector<std::uint32_t> patches;
  for (std::uint32_t i = 0; i < complex.polygons.size(); ++i)
    patches.push_back(sets.lowest(i));
  return patches;
}

void add_patches(const CellComplex& complex, MeshIntersection& result) {
  const std::vector<std::uint32_t> patch = patches_of(complex);
  std::vector<std::uint32_t> order(patch.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return patch[i] < patch[j]; });
  for (std::uint32_t i : order) {
    if (patch[i] == i) result.patches.push_back({size_of(result.polygons), 0});
    ++result.patches.back().polygon_count;
    const Cell& cell = complex.polygons[i];
    result.polygons.push_back({cell.corner, cell.count, cell.first_pair, cell.pair_count});
  }
}

void add_touching_points(const CellComplex& complex, MeshIntersection& result) {
  std::vector<bool> is_joined = contacts::corners_of_polygons(complex);
  for (const Cell& segment : complex.segments)
    is_joined[segment.corner[0]] = is_joined[segment.corner[1]] = true;
  for (const Cell& cell : complex.points) {
    if (is_joined[cell.corner[0]]) continue;
    result.touching_points.push_back({cell.corner[0], cell.first_pair, cell.pair_count});
  }
}

}  // namespace

MeshIntersection find_intersection(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                                   const IntersectionSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> MeshIntersection {
    CellComplex complex = contacts::intersect_cells(mesh_a, mesh_b, settings.volume, work);
    MeshIntersection result;
    add_points(complex, result);
    add_curves(complex, result);
    add_patches(complex, result);
    add_touching_points(complex, result);
    result.pairs = std::move(complex.pairs);
    return result;
  });
}

}  // namespace graze

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/data/directed_edges.h>
#include <graze/engine/mesh/health/inside_out.h>
#include <graze/engine/mesh/health/mesh_parts.h>
#include <graze/engine/mesh/mesh_health.h>
#include <graze/engine/mesh/pairs/self_pairs.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/query/sort_pairs.h>
#include <graze/narrowphase/triangle_pair/adjacent_triangles.h>

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace graze {
namespace {

void list_edges(std::span<const DirectedEdge> edges, MeshHealth& health) {
  for_each_edge(edges, [&](std::span<const DirectedEdge> edge) {
    const FaultyEdge faulty{
        {edge[0].low, edge[0].high}, edge[0].of.triangle, static_cast<std::uint32_t>(edge.size())};
    if (edge.size() == 1) health.open_edges.push_back(faulty);
    if (edge.size() > 2) health.non_manifold_edges.push_back(faulty);
    if (std::labs(excess_of(edge)) > 1) health.turned_edges.push_back(faulty);
  });
}

void list_triangles(const Mesh& mesh, MeshHealth& health) {
  const std::span<const std::uint32_t> welded = mesh.welded();
  std::vector<std::pair<TriangleIndices, std::uint32_t>> sorted;
  sorted.reserve(mesh.triangles().size());
  for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
    TriangleIndices corners = mesh.triangles()[i];
    for (std::uint32_t& corner : corners)
      corner = welded[corner];
    std::sort(corners.begin(), corners.end());
    sorted.emplace_back(corners, i);
    if (narrowphase::is_degenerate(mesh.triangle(i))) health.degenerate_triangles.push_back(i);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1, earliest = 0; i < sorted.size(); ++i) {
    if (sorted[i].first != sorted[earliest].first) earliest = i;
    if (i != earliest)
      health.duplicate_triangles.push_back({sorted[i].second, sorted[earliest].second});
  }
  std::sort(health.duplicate_triangles.begin(), health.duplicate_triangles.end(),
            [](const DuplicateTriangle& one, const DuplicateTriangle& other) {
              return one.triangle < other.triangle;
            });
}

CrossedParts list_crossings(const Mesh& mesh, const MeshParts& parts, const CheckSettings& settings,
                            Work& work, MeshHealth& health) {
  constexpr std::size_t kReports = 200;
  const std::size_t total = mesh.triangles().size();
  std::size_t next_report = total / kReports;
  CrossedParts crossed;
  for_each_self_intersection(
      mesh, work,
      [&](TrianglePair pair) {
        health.self_intersections.pairs.push_back(pair);
        crossed.note(pair, parts);
      },
      [&](std::size_t done) {
        if (!settings.on_progress || (done < next_report && done != total)) return;
        next_report = done + total / kReports;
        bvh::in_users_arithmetic([&] { settings.on_progress(done, total); });
      });
  sort_pairs(health.self_intersections.pairs);
  return crossed;
}

}  // namespace

std::size_t MeshHealth::fault_count() const {
  return open_edges.size() + non_manifold_edges.size() + turned_edges.size() +
         degenerate_triangles.size() + duplicate_triangles.size() + inside_out_parts.size() +
         self_intersections.size();
}

bool MeshHealth::is_healthy() const {
  return fault_count() == 0;
}

MeshHealth check(const Mesh& mesh, const CheckSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> MeshHealth {
    CountedWork counted(work);
    MeshHealth health;
    const std::vector<DirectedEdge> edges = directed_edges_of(mesh);
    list_edges(edges, health);
    list_triangles(mesh, health);
    const MeshParts parts = parts_of(mesh, edges);
    const CrossedParts crossed = list_crossings(mesh, parts, settings, counted.work(), health);
    health.inside_out_parts = inside_out_parts(mesh, parts, crossed, counted.work());
    return health;
  });
}

}  // namespace graze

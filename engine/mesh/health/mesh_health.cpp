#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/hash.h>
#include <graze/engine/mesh/data/directed_edges.h>
#include <graze/engine/mesh/health/mesh_parts.h>
#include <graze/engine/mesh/health/volume_sign.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/mesh_health.h>
#include <graze/engine/mesh/pairs/self_pairs.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/query/sort_pairs.h>
#include <graze/narrowphase/triangle_pair/adjacent_triangles.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <unordered_set>
#include <utility>

namespace graze {
namespace {

using narrowphase::Sign;

/// Parts that cross or touch each other: pairs of their numbers, the lower one first.
using MetParts = std::unordered_set<std::uint64_t>;

std::uint64_t key_of(std::uint32_t part_a, std::uint32_t part_b) {
  const auto [low, high] = std::minmax(part_a, part_b);
  return static_cast<std::uint64_t>(high) << 32 | low;
}

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

MetParts list_crossings(const Mesh& mesh, const MeshParts& parts, const CheckSettings& settings,
                        Work& work, MeshHealth& health) {
  constexpr std::size_t kReports = 200;
  const std::size_t total = mesh.triangles().size();
  std::size_t next_report = total / kReports;
  MetParts met;
  for_each_crossing_self_pair(
      mesh, work,
      [&](TrianglePair pair) {
        health.self_intersections.pairs.push_back(pair);
        const std::uint32_t part_a = parts.part_of[pair.a], part_b = parts.part_of[pair.b];
        if (part_a != part_b) met.insert(key_of(part_a, part_b));
      },
      [&](std::size_t done) {
        if (!settings.on_progress || (done < next_report && done != total)) return;
        next_report = done + total / kReports;
        bvh::in_users_arithmetic([&] { settings.on_progress(done, total); });
      });
  sort_pairs(health.self_intersections.pairs);
  return met;
}

constexpr std::uint32_t kNoPart = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t kSeveralParts = kNoPart - 1;

/// For each welded vertex the part whose triangles have it, if one alone does.
std::vector<std::uint32_t> parts_of_vertices(const Mesh& mesh, const MeshParts& parts) {
  std::vector<std::uint32_t> owners(mesh.vertices().size(), kNoPart);
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    for (const std::uint32_t vertex : mesh.triangles()[i]) {
      std::uint32_t& owner = owners[mesh.welded()[vertex]];
      owner = owner == kNoPart || owner == parts.part_of[i] ? parts.part_of[i] : kSeveralParts;
    }
  }
  return owners;
}

/// A vertex that no other part has; nothing if there is none.
std::optional<std::uint32_t> own_vertex(const Mesh& mesh, std::span<const std::uint32_t> triangles,
                                        std::uint32_t part,
                                        const std::vector<std::uint32_t>& owners) {
  for (const std::uint32_t index : triangles) {
    for (const std::uint32_t vertex : mesh.triangles()[index]) {
      if (owners[mesh.welded()[vertex]] == part) return vertex;
    }
  }
  return std::nullopt;
}

/// How many of the oriented parts enclose the point, which lies on none but `part`, not counting
/// that and those that it meets.
std::uint32_t depth_at(const Eigen::Vector3d& point, std::uint32_t part, const Mesh& mesh,
                       const MeshParts& parts, const MetParts& met, Work& work) {
  std::vector<std::uint32_t> crossed;
  crossed_triangles(mesh, point, work, crossed);
  for (std::uint32_t& index : crossed)
    index = parts.part_of[index];
  std::sort(crossed.begin(), crossed.end());
  std::uint32_t depth = 0;
  for (std::size_t i = 0; i < crossed.size();) {
    const std::uint32_t other = crossed[i];
    std::size_t count = 0;
    for (; i < crossed.size() && crossed[i] == other; ++i)
      ++count;
    depth += other != part && count % 2 == 1 && parts.is_oriented[other] &&
             !met.contains(key_of(part, other));
  }
  return depth;
}

void list_inside_out(const Mesh& mesh, const MeshParts& parts, const MetParts& met, Work& work,
                     MeshHealth& health) {
  const std::vector<std::uint32_t> owners = parts_of_vertices(mesh, parts);
  for (std::uint32_t part = 0; part < parts.size(); ++part) {
    if (!parts.is_oriented[part]) continue;
    const std::span<const std::uint32_t> triangles = parts.triangles_of(part);
    const Sign sign = volume_sign(mesh, triangles);
    if (sign == Sign::Zero) continue;
    const std::optional<std::uint32_t> vertex = own_vertex(mesh, triangles, part, owners);
    if (!vertex) continue;
    const std::uint32_t depth =
        parts.size() == 1 ? 0 : depth_at(mesh.vertices()[*vertex], part, mesh, parts, met, work);
    if ((sign == Sign::Positive) == (depth % 2 == 0)) continue;
    health.inside_out_parts.push_back(
        {triangles.front(), static_cast<std::uint32_t>(triangles.size()), depth});
  }
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
    const MetParts met = list_crossings(mesh, parts, settings, counted.work(), health);
    list_inside_out(mesh, parts, met, counted.work(), health);
    return health;
  });
}

}  // namespace graze

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
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace graze {
namespace {

using narrowphase::Sign;

/// The pairs of closed surfaces that cross or touch, and the parts that others of their own
/// surface, or they themselves, cross or touch.
struct Met {
  std::unordered_set<std::uint64_t> surfaces;
  std::unordered_set<std::uint32_t> crossed;
};

std::uint64_t key_of(std::uint32_t surface_a, std::uint32_t surface_b) {
  const auto [low, high] = std::minmax(surface_a, surface_b);
  return static_cast<std::uint64_t>(high) << 32 | low;
}

void note_crossing(TrianglePair pair, const MeshParts& parts, Met& met) {
  const std::uint32_t part_a = parts.part_of[pair.a], part_b = parts.part_of[pair.b];
  const std::uint32_t surface_a = parts.surface_of[part_a], surface_b = parts.surface_of[part_b];
  if (surface_a != surface_b) {
    met.surfaces.insert(key_of(surface_a, surface_b));
  } else {
    met.crossed.insert({part_a, part_b});
  }
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

Met list_crossings(const Mesh& mesh, const MeshParts& parts, const CheckSettings& settings,
                   Work& work, MeshHealth& health) {
  constexpr std::size_t kReports = 200;
  const std::size_t total = mesh.triangles().size();
  std::size_t next_report = total / kReports;
  Met met;
  for_each_self_intersection(
      mesh, work,
      [&](TrianglePair pair) {
        health.self_intersections.pairs.push_back(pair);
        note_crossing(pair, parts, met);
      },
      [&](std::size_t done) {
        if (!settings.on_progress || (done < next_report && done != total)) return;
        next_report = done + total / kReports;
        bvh::in_users_arithmetic([&] { settings.on_progress(done, total); });
      });
  sort_pairs(health.self_intersections.pairs);
  return met;
}

/// Returns the first triangle that has area.
std::optional<Triangle> face_of(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
  for (const std::uint32_t index : triangles) {
    const Triangle triangle = mesh.triangle(index);
    if (!narrowphase::is_degenerate(triangle)) return triangle;
  }
  return std::nullopt;
}

/// Returns the closed surfaces that enclose a point beside a triangle, ascending.
std::vector<std::uint32_t> surfaces_around(const narrowphase::FaceSample& sample, const Mesh& mesh,
                                           const MeshParts& parts, Work& work) {
  std::vector<std::uint32_t> crossed;
  crossed_triangles(mesh, sample, work, crossed);
  for (std::uint32_t& index : crossed)
    index = parts.surface_of[parts.part_of[index]];
  std::sort(crossed.begin(), crossed.end());
  std::vector<std::uint32_t> around;
  for (std::size_t i = 0; i < crossed.size();) {
    const std::uint32_t surface = crossed[i];
    bool is_odd = false;
    for (; i < crossed.size() && crossed[i] == surface; ++i)
      is_odd = !is_odd;
    if (is_odd && surface != MeshParts::kNone) around.push_back(surface);
  }
  return around;
}

bool holds(const std::vector<std::uint32_t>& list, std::uint32_t entry) {
  return std::binary_search(list.begin(), list.end(), entry);
}

/// Lists the parts that are inside out. A part is judged beside one of its triangles. An oriented
/// one faces outwards as the sign of its volume says; another one if the surface that it is of
/// encloses what is behind it there, which is so all over it unless something of that surface
/// crosses it.
void list_inside_out(const Mesh& mesh, const MeshParts& parts, const Met& met, Work& work,
                     MeshHealth& health) {
  for (std::uint32_t part = 0; part < parts.size(); ++part) {
    const std::uint32_t surface = parts.surface_of[part];
    const bool is_oriented = parts.is_oriented[part];
    if (surface == MeshParts::kNone) continue;
    if (!is_oriented && (!parts.is_consistent[part] || met.crossed.contains(part))) continue;
    const std::span<const std::uint32_t> triangles = parts.triangles_of(part);
    const Sign sign = is_oriented ? volume_sign(mesh, triangles) : Sign::Zero;
    const std::optional<Triangle> face = face_of(mesh, triangles);
    if (!face || (is_oriented && sign == Sign::Zero)) continue;
    bool faces_out = sign == Sign::Positive;
    std::vector<std::uint32_t> around;
    if (!is_oriented || parts.size() > 1)
      around = surfaces_around({*face, Sign::Positive}, mesh, parts, work);
    if (!is_oriented) {
      faces_out = holds(surfaces_around({*face, Sign::Negative}, mesh, parts, work), surface);
      if (holds(around, surface) == faces_out) continue;
    }
    const auto depth = static_cast<std::uint32_t>(
        std::count_if(around.begin(), around.end(), [&](std::uint32_t other) {
          return other != surface && !met.surfaces.contains(key_of(surface, other));
        }));
    if (faces_out == (depth % 2 == 0)) continue;
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
    const Met met = list_crossings(mesh, parts, settings, counted.work(), health);
    list_inside_out(mesh, parts, met, counted.work(), health);
    return health;
  });
}

}  // namespace graze

#include <graze/engine/mesh/curves/disjoint_sets.h>
#include <graze/engine/mesh/health/mesh_parts.h>

#include <algorithm>
#include <utility>

namespace graze {
namespace {

/// Numbers the sets in the order of their lowest triangles, and lists their triangles.
void number_parts(contacts::DisjointSets& sets, MeshParts& parts) {
  const auto count = static_cast<std::uint32_t>(parts.part_of.size());
  std::vector<std::uint32_t> sizes;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t lowest = sets.lowest(i);
    if (lowest == i) sizes.push_back(0);
    parts.part_of[i] =
        lowest == i ? static_cast<std::uint32_t>(sizes.size() - 1) : parts.part_of[lowest];
    ++sizes[parts.part_of[i]];
  }
  parts.first.assign(sizes.size() + 1, 0);
  for (std::size_t part = 0; part < sizes.size(); ++part)
    parts.first[part + 1] = parts.first[part] + sizes[part];
  std::vector<std::uint32_t> next(parts.first.begin(), parts.first.end() - 1);
  parts.triangles.resize(count);
  for (std::uint32_t i = 0; i < count; ++i)
    parts.triangles[next[parts.part_of[i]]++] = i;
}

/// Marks the parts of which more triangles go along this edge one way than the other.
void mark_unbalanced(std::span<const DirectedEdge> edge, MeshParts& parts) {
  if (edge.size() == 2) {  // both triangles are of one part
    if (excess_of(edge) == 0) return;
    const std::uint32_t part = parts.part_of[edge[0].of.triangle];
    parts.is_oriented[part] = parts.is_consistent[part] = false;
    return;
  }
  std::vector<std::pair<std::uint32_t, int>> senses;
  for (const DirectedEdge& each : edge)
    senses.emplace_back(parts.part_of[each.of.triangle], each.is_ascending ? 1 : -1);
  std::sort(senses.begin(), senses.end());
  for (std::size_t i = 0; i < senses.size();) {
    const std::uint32_t part = senses[i].first;
    long excess = 0;
    for (; i < senses.size() && senses[i].first == part; ++i)
      excess += senses[i].second;
    if (excess != 0) parts.is_oriented[part] = false;
  }
}

/// Returns the parts that are not oriented at an edge, once for each of their triangles there, by
/// their surfaces so far; ascending.
std::vector<std::uint32_t> surfaces_at(std::span<const DirectedEdge> edge, const MeshParts& parts,
                                       contacts::DisjointSets& surfaces) {
  std::vector<std::uint32_t> at;
  for (const DirectedEdge& each : edge) {
    const std::uint32_t part = parts.part_of[each.of.triangle];
    if (!parts.is_oriented[part]) at.push_back(surfaces.lowest(part));
  }
  std::sort(at.begin(), at.end());
  return at;
}

void find_surfaces(std::span<const DirectedEdge> edges, MeshParts& parts) {
  contacts::DisjointSets surfaces(parts.size());
  for_each_edge(edges, [&](std::span<const DirectedEdge> edge) {
    const std::vector<std::uint32_t> at = surfaces_at(edge, parts, surfaces);
    for (std::size_t i = 1; i < at.size(); ++i)
      surfaces.join(at[0], at[i]);
  });
  std::vector<bool> is_open(parts.size(), false);
  for_each_edge(edges, [&](std::span<const DirectedEdge> edge) {
    const std::vector<std::uint32_t> at = surfaces_at(edge, parts, surfaces);
    if (at.size() % 2 == 1) is_open[at[0]] = true;  // all of one surface
  });
  parts.surface_of.resize(parts.size());
  for (std::uint32_t part = 0; part < parts.size(); ++part) {
    const std::uint32_t surface = surfaces.lowest(part);
    parts.surface_of[part] = is_open[surface] ? MeshParts::kNone : surface;
  }
}

}  // namespace

MeshParts parts_of(const Mesh& mesh, std::span<const DirectedEdge> edges) {
  MeshParts parts;
  parts.part_of.resize(mesh.triangles().size());
  contacts::DisjointSets sets(parts.part_of.size());
  for_each_edge(edges, [&](std::span<const DirectedEdge> edge) {
    if (edge.size() == 2) sets.join(edge[0].of.triangle, edge[1].of.triangle);
  });
  number_parts(sets, parts);
  parts.is_oriented.assign(parts.first.size() - 1, true);
  parts.is_consistent = parts.is_oriented;
  // A triangle that repeats a vertex has no edges, and is a part that encloses nothing.
  for_each_edge(edges, [&](std::span<const DirectedEdge> edge) { mark_unbalanced(edge, parts); });
  find_surfaces(edges, parts);
  return parts;
}

}  // namespace graze

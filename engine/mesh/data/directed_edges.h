#pragma once

// These are the edges of a mesh between welded vertices, as its triangles go along them. They are
// private to the library.

#include <graze/engine/mesh/data/orientation.h>
#include <graze/engine/mesh/mesh.h>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace graze {

/// An edge between welded vertices, as one triangle goes along it.
struct DirectedEdge {
  std::uint32_t low, high;
  bool is_ascending;  ///< true if the triangle goes from `low` to `high`
  TriangleEdge of;
};

/// Returns all directed edges, by their vertices, then by triangle, in O(n log n). A triangle that
/// repeats a welded vertex has none: it goes along its one edge both ways.
std::vector<DirectedEdge> directed_edges_of(const Mesh& mesh);

/// Calls `on_edge(those)` with the directed edges of each edge, in the order of the edges.
template <typename OnEdge>
void for_each_edge(std::span<const DirectedEdge> edges, OnEdge&& on_edge) {
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].low == edges[first].low &&
           edges[last].high == edges[first].high)
      ++last;
    on_edge(edges.subspan(first, last - first));
  }
}

/// Returns how many more triangles go from the lower vertex to the higher than back.
inline long excess_of(std::span<const DirectedEdge> of_one_edge) {
  long excess = 0;
  for (const DirectedEdge& edge : of_one_edge)
    excess += edge.is_ascending ? 1 : -1;
  return excess;
}

}  // namespace graze

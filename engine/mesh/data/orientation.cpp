#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/engine/mesh/data/orientation.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace graze {
namespace {

/// An edge between welded vertices, as a triangle goes along it.
struct DirectedEdge {
  std::uint32_t low, high;
  bool is_ascending;
  TriangleEdge of;
};

std::vector<DirectedEdge> edges_of(const Mesh& mesh) {
  const std::span<const std::uint32_t> welded = mesh.welded();
  const std::span<const TriangleIndices> triangles = mesh.triangles();
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t s = welded[triangles[i][static_cast<std::size_t>(k)]];
      const std::uint32_t t = welded[triangles[i][static_cast<std::size_t>((k + 1) % 3)]];
      if (s != t) edges.push_back({std::min(s, t), std::max(s, t), s < t, {i, k}});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const DirectedEdge& s, const DirectedEdge& t) {
    if (s.low != t.low) return s.low < t.low;
    if (s.high != t.high) return s.high < t.high;
    return s.of.triangle != t.of.triangle ? s.of.triangle < t.of.triangle : s.of.k < t.of.k;
  });
  return edges;
}

void take_first(const TriangleEdge& edge, std::optional<TriangleEdge>& first) {
  if (!first || edge.triangle < first->triangle ||
      (edge.triangle == first->triangle && edge.k < first->k))
    first = edge;
}

}  // namespace

const Orientation& orientation_of(const Mesh& mesh) {
  const auto& data = MeshAccess::data(mesh);
  std::call_once(data.orientation_flag, [&] {
    const std::vector<DirectedEdge> edges = edges_of(mesh);
    for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
      long more = 0;
      for (; last < edges.size() && edges[last].low == edges[first].low &&
             edges[last].high == edges[first].high;
           ++last)
        more += edges[last].is_ascending ? 1 : -1;
      if (more != 0) take_first(edges[first].of, data.orientation.unpaired);
      if (std::labs(more) > 1) take_first(edges[first].of, data.orientation.turned);
    }
  });
  return data.orientation;
}

}  // namespace graze

#include <graze/engine/mesh/data/directed_edges.h>
#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/engine/mesh/data/orientation.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace graze {
namespace {

void take_first(const TriangleEdge& edge, std::optional<TriangleEdge>& first) {
  if (!first || edge.triangle < first->triangle ||
      (edge.triangle == first->triangle && edge.k < first->k))
    first = edge;
}

}  // namespace

std::vector<DirectedEdge> directed_edges_of(const Mesh& mesh) {
  const std::span<const std::uint32_t> welded = mesh.welded();
  const std::span<const TriangleIndices> triangles = mesh.triangles();
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const TriangleIndices corners{welded[triangles[i][0]], welded[triangles[i][1]],
                                  welded[triangles[i][2]]};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t s = corners[static_cast<std::size_t>(k)];
      const std::uint32_t t = corners[static_cast<std::size_t>((k + 1) % 3)];
      edges.push_back({std::min(s, t), std::max(s, t), s < t, {i, k}});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const DirectedEdge& s, const DirectedEdge& t) {
    if (s.low != t.low) return s.low < t.low;
    if (s.high != t.high) return s.high < t.high;
    return s.of.triangle != t.of.triangle ? s.of.triangle < t.of.triangle : s.of.k < t.of.k;
  });
  return edges;
}

const Orientation& orientation_of(const Mesh& mesh) {
  const auto& data = MeshAccess::data(mesh);
  std::call_once(data.orientation_flag, [&] {
    for_each_edge(directed_edges_of(mesh), [&](std::span<const DirectedEdge> edge) {
      const long excess = excess_of(edge);
      if (excess != 0) take_first(edge.front().of, data.orientation.unpaired);
      if (std::labs(excess) > 1) take_first(edge.front().of, data.orientation.turned);
    });
  });
  return data.orientation;
}

}  // namespace graze
